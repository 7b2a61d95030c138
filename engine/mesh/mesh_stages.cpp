#include "engine/mesh/mesh_stages.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/fixed/divide.h"
#include "engine/math/soft_float.h"
#include "engine/view/project.h"

namespace oblong {

namespace {

/// a + (b - a) blend / 256.
template <class Value>
Vec3<Value> blended(const Vec3<Value>& a, const Vec3<Value>& b, std::int32_t blend_256) {
    return between(a, b, WorldWide::from_raw(blend_256), WorldWide::from_raw(256));
}

/// A number with the highest bit of the largest component's magnitude.
template <class T>
constexpr std::uint64_t size_bits(const Vec3<T>& v) {
    return magnitude(v.x) | magnitude(v.y) | magnitude(v.z);
}

/// b - a, each component clamped below 2^30 steps, so that the cross product of two fits 64 bits. Exact within 2^17
/// units.
constexpr Vec3<World> bounded_difference(const Vec3<World>& a, const Vec3<World>& b) {
    const auto bounded = [](World from, World to) {
        constexpr std::int64_t kMost = (1 << 30) - 1;
        return World::from_raw(static_cast<std::int32_t>(std::clamp(widening_difference(to, from).raw, -kMost, kMost)));
    };
    return {bounded(a.x, b.x), bounded(a.y, b.y), bounded(a.z, b.z)};
}

/// (C - A) x (B - A), toward the front.
constexpr Vec3<Fixed<std::int64_t, 24>> object_normal(const MeshTriangle& triangle,
                                                      std::span<const MeshVertex> vertices) {
    const Vec3<World>& a = vertices[triangle.vertices[0]].position;
    return cross(bounded_difference(a, vertices[triangle.vertices[2]].position),
                 bounded_difference(a, vertices[triangle.vertices[1]].position));
}

/// Whether normal . way is above 0, exactly; in 64 bits if they hold it, as for all but huge meshes.
bool is_above_zero(const Vec3<Fixed<std::int64_t, 24>>& normal, const Vec3<WorldWide>& way) {
    // Three products below 2^(n + w), n and w the bits of each: their sum fits if n + w is at most 61.
    using Product = Fixed<std::int64_t, 36>;
    if (log2_floor(size_bits(normal) | 1) + log2_floor(size_bits(way) | 1) + 2 <= 61)
        return dot(normal, way) > Product{};
    WideSum sum;
    sum.add_product(normal.x, way.x);
    sum.add_product(normal.y, way.y);
    sum.add_product(normal.z, way.z);
    return sum.scaled(0).mantissa > 0;
}

/// Whether all parts are from -2^bits to 2^bits - 1 steps.
template <int kBits>
constexpr bool is_within_bits(const Vec3<WorldWide>& v) {
    constexpr std::int64_t kEnd = std::int64_t{1} << kBits;
    return static_cast<std::uint64_t>((v.x.raw + kEnd) | (v.y.raw + kEnd) | (v.z.raw + kEnd)) >> (kBits + 1) == 0;
}

/// The same of 32 bits.
template <int kBits>
constexpr bool is_within_bits(const Vec3<World>& v) {
    constexpr std::uint32_t kEnd = std::uint32_t{1} << kBits;
    return ((v.x.bits() + kEnd) | (v.y.bits() + kEnd) | (v.z.bits() + kEnd)) >> (kBits + 1) == 0;
}

/// a x b of vectors within 2^15 steps: its parts are below 2^31.
constexpr Vec3<Fixed<std::int32_t, 24>> short_cross(const Vec3<World>& a, const Vec3<World>& b) {
    const auto area = [](World ax, World ay, World bx, World by) {
        return Fixed<std::int32_t, 24>::from_raw(ax.raw * by.raw - ay.raw * bx.raw);
    };
    return {area(a.y, a.z, b.y, b.z), area(a.z, a.x, b.z, b.x), area(a.x, a.y, b.x, b.y)};
}

/// is_facing() in 32 bits; none if these do not suffice. Differences are taken modulo 2^32: as A is within 2^30 steps,
/// those that come out below 2^29 are exact.
[[maybe_unused]] std::optional<bool> is_short_facing(const Vec3<World>& a, const Vec3<World>& b_at,
                                                     const Vec3<World>& c_at, const Vec3<World>& object_eye) {
    const auto from_a = [&](const Vec3<World>& p) {
        const auto way = [](World to, World from) {
            return World::from_raw(static_cast<std::int32_t>(to.bits() - from.bits()));
        };
        return Vec3<World>{way(p.x, a.x), way(p.y, a.y), way(p.z, a.z)};
    };
    const auto to_eye = from_a(object_eye), b = from_a(b_at), c = from_a(c_at);
    if (!is_within_bits<30>(a) || !is_within_bits<29>(to_eye) || !is_within_bits<15>(b) || !is_within_bits<15>(c))
        return std::nullopt;
    return dot(short_cross(c, b), to_eye) > Fixed<std::int64_t, 36>{};
}

/// Whether a triangle faces the eye, exactly.
bool is_facing(const MeshTriangle& triangle, std::span<const MeshVertex> vertices, const Vec3<World>& object_eye) {
    const Vec3<World>& a = vertices[triangle.vertices[0]].position;
    if constexpr (native::kHasShortRegisters)
        if (const auto is_short = is_short_facing(a, vertices[triangle.vertices[1]].position,
                                                  vertices[triangle.vertices[2]].position, object_eye))
            return *is_short;
    const auto from_a = [&](const Vec3<World>& p) { return widening_difference(p, a); };
    const auto to_eye = from_a(object_eye), b = from_a(vertices[triangle.vertices[1]].position),
               c = from_a(vertices[triangle.vertices[2]].position);
    // Three products below 2^(2 * 17 + 1 + 25): their sum fits 64 bits. Nearly all triangles take this path.
    if (is_within_bits<17>(b) && is_within_bits<17>(c) && is_within_bits<25>(to_eye)) {
        const auto product = [](WorldWide one, WorldWide other) {
            return std::int64_t{static_cast<std::int32_t>(one.raw)} * static_cast<std::int32_t>(other.raw);
        };
        return to_eye.x.raw * (product(c.y, b.z) - product(c.z, b.y)) +
                   to_eye.y.raw * (product(c.z, b.x) - product(c.x, b.z)) +
                   to_eye.z.raw * (product(c.x, b.y) - product(c.y, b.x)) >
               0;
    }
    return is_above_zero(object_normal(triangle, vertices), to_eye);
}

/// Whether products of the point with entries below 2^4, and their sums, fit 64 bits: within 2^13 units.
constexpr bool is_small(const Vec3<World>& point) {
    return is_within_bits<World::kFractionBits + 13>(point);
}

/// times() for small entries and a small point: the same bits, without products of more than 64 bits.
constexpr Vec3<Entry> times_small(const Matrix4& matrix, const Vec3<World>& point) {
    const auto row_times = [&](const std::array<Entry, 4>& row) {
        const auto part = [](Entry entry, World of) { return convert<Entry>(bounded_product(entry, of)); };
        return part(row[0], point.x) + part(row[1], point.y) + part(row[2], point.z) + row[3];
    };
    return {row_times(matrix.rows[0]), row_times(matrix.rows[1]), row_times(matrix.rows[2])};
}

Vec3<Entry> times(const Matrix4& matrix, const Vec3<World>& point) {
    const std::array column{convert<Entry>(point.x), convert<Entry>(point.y), convert<Entry>(point.z),
                            Entry::from_int(1)};
    return {matrix.row_times(0, column), matrix.row_times(1, column), matrix.row_times(2, column)};
}

InverseZ inverse_z_at(View z) {
    if (z <= View::from_raw(1 << 9)) return kGreatestMeshInverseZ;
    constexpr std::uint64_t kOne = std::uint64_t{1} << (InverseZ::kFractionBits + View::kFractionBits);
    return InverseZ::from_raw(static_cast<std::int64_t>(divide(kOne, static_cast<std::uint64_t>(z.raw)).quotient));
}

/// A barycentric coordinate: 0 to 1.
using Weight = Fixed<std::int64_t, 30>;

/// Of the corners B and C; A's is the rest.
struct Weights {
    Weight b, c;
};

/// How many low bits to drop from two vectors so that their cross product fits 64 bits.
int bits_too_many(const Vec3<View>& a, const Vec3<View>& b) {
    return std::max(log2_floor(size_bits(a) | size_bits(b) | 1) - 28, 0);
}

/// The barycentric coordinates of a point in a triangle's plane: its areas with two corners divided by the whole area,
/// in the projection along the axis that makes the triangle largest.
Weights weights_at(const Vec3<View>& p, const Vec3<View>& a, const Vec3<View>& b, const Vec3<View>& c) {
    const int shift = bits_too_many(b - a, c - a);
    const auto scaled = [&](const Vec3<View>& v) {
        const auto part = [shift](View way) { return floor_of<View::kFractionBits>(floor_shift(way, shift)); };
        return std::array{part(v.x - a.x), part(v.y - a.y), part(v.z - a.z)};
    };
    const auto to_b = scaled(b), to_c = scaled(c), to_p = scaled(p);
    const auto area = [](const auto& one, const auto& other, std::size_t axis) {
        const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
        return one[i] * other[j] - one[j] * other[i];
    };
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(area(to_b, to_c, i)) > std::abs(area(to_b, to_c, axis))) axis = i;
    const std::int64_t whole = area(to_b, to_c, axis);
    if (whole == 0) return {};
    const auto share = [whole](std::int64_t part, Weight most) {
        const auto weight = Weight::from_raw(mul_div(part, std::int64_t{1} << Weight::kFractionBits, whole));
        return std::clamp(weight, Weight{}, most);
    };
    const Weight of_b = share(area(to_p, to_c, axis), Weight::from_int(1));
    return {of_b, share(area(to_b, to_p, axis), Weight::from_int(1) - of_b)};
}

/// a + (b - a) weights.b + (c - a) weights.c.
template <class Value>
Value mixed(Value a, Value b, Value c, const Weights& weights) {
    constexpr auto kOne = Weight::from_int(1);
    const auto part = [&](Value to, Weight weight) { return std::int64_t{between(a, to, weight, kOne).raw} - a.raw; };
    return Value::from_raw(static_cast<typename Value::Raw>(a.raw + part(b, weights.b) + part(c, weights.c)));
}

CornerValues mixed(const std::array<const CornerValues*, 3>& values, const Weights& weights) {
    const CornerValues &a = *values[0], &b = *values[1], &c = *values[2];
    return {mixed(a.u, b.u, c.u, weights),
            mixed(a.v, b.v, c.v, weights),
            mixed(a.light, b.light, c.light, weights),
            {mixed(a.normal.x, b.normal.x, c.normal.x, weights), mixed(a.normal.y, b.normal.y, c.normal.y, weights),
             mixed(a.normal.z, b.normal.z, c.normal.z, weights)}};
}

}  // namespace

std::span<const MeshVertex> pose_of(const PlacedMesh& placed, std::vector<MeshVertex>& scratch) {
    const std::vector<MeshVertex>&from = frame_of(placed).vertices, &to = next_frame_of(placed).vertices;
    if (placed.blend_256 <= 0 || &from == &to) return from;
    if (placed.blend_256 >= 256) return to;
    scratch.clear();
    for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i)
        scratch.push_back({blended(from[i].position, to[i].position, placed.blend_256),
                           normalised(blended(from[i].normal, to[i].normal, placed.blend_256))});
    return scratch;
}

Vec3<World> to_object(const Vec3<World>& world_eye, const MeshTransform& transform) {
    return saturating_convert<World>(times(transform.to_object, world_eye));
}

void find_facing(std::span<const MeshTriangle> triangles, std::span<const MeshVertex> object_vertices,
                 const Vec3<World>& object_eye, std::vector<std::uint32_t>& facing) {
    facing.clear();
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto& [a, b, c] = triangles[i].vertices;
        if (std::max({a, b, c}) >= object_vertices.size()) continue;
        if (is_facing(triangles[i], object_vertices, object_eye)) facing.push_back(i);
    }
}

void find_facing(std::span<const FacingPlane> planes, const Vec3<World>& object_eye,
                 std::vector<std::uint32_t>& facing) {
    facing.resize(planes.size());
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < planes.size(); ++i) {
        facing[count] = i;  // kept if it faces the eye: no branch, as half of all triangles do
        count += dot(planes[i].normal, object_eye) > planes[i].distance;
    }
    facing.resize(count);
}

bool is_near_enough(const Vec3<World>& object_eye) {
    return size_bits(object_eye) >> (World::kFractionBits + 17) == 0;
}

Vec3<Unit> world_normal(const MeshTriangle& triangle, std::span<const MeshVertex> object_vertices,
                        const MeshTransform& transform) {
    return world_normal(normalised(object_normal(triangle, object_vertices)), transform);
}

Vec3<World> world_position(const Vec3<World>& object_position, const MeshTransform& transform) {
    const Matrix4& matrix = transform.to_world;
    if (!transform.has_small_entries || !is_small(object_position))
        return saturating_convert<World>(times(matrix, object_position));
    const Vec3<Entry> sum = times_small(matrix, object_position);
    const auto rounded = [](Entry part) {
        return saturated_to<World>(floor_of<World::kFractionBits>(convert<WorldWide>(part)));
    };
    return {rounded(sum.x), rounded(sum.y), rounded(sum.z)};
}

Vec3<Unit> world_normal(const Vec3<Unit>& object_normal, const MeshTransform& transform) {
    if (!transform.turn) return normalised(transform.normals * convert<Entry>(object_normal));
    const auto rounded = [&](const Vec3<Unit>& row) {
        return saturated_to<Unit>(floor_of<30>(convert<Fixed<std::int64_t, 30>>(dot(row, object_normal))));
    };
    const auto& [x, y, z] = *transform.turn;
    return {rounded(x), rounded(y), rounded(z)};
}

MeshToView make_mesh_to_view(const Vec3<World>& world_origin, const MeshTransform& transform, const ViewContext& view) {
    using Coefficient = MeshToView::Coefficient;
    MeshToView result;
    if (!transform.has_small_entries || view.adjusts_positions) return result;
    const auto from_eye = widening_difference(world_origin, view.eye);
    std::int64_t bits = 0;
    // Entries are below 2^4, those of sheared axes below 2: sums of three products fit, and mostly a coefficient.
    const auto row = [&](const Vec3<Unit>& axis) {
        const auto along = [&](std::size_t column) {
            const auto& rows = transform.to_world.rows;
            const auto entry = [&](std::size_t i) { return convert<Coefficient>(rows[i][column]); };
            const auto sum =
                convert<Fixed<std::int64_t, 26>>(dot(axis, Vec3<Coefficient>{entry(0), entry(1), entry(2)}));
            bits |= sum.raw ^ floor_shift(sum.raw, 63);
            return Coefficient::from_raw(static_cast<std::int32_t>(sum.raw));
        };
        return Vec3<Coefficient>{along(0), along(1), along(2)};
    };
    const auto& [right, up, forward] = view.axes;
    result.rows = {row(right), row(up), row(forward)};
    result.origin = convert<Fixed<std::int64_t, 38>>(
        Vec3<PlaneDistance>{dot(from_eye, right), dot(from_eye, up), dot(from_eye, forward)});
    result.is_usable = bits >> 31 == 0;
    return result;
}

ViewBox view_box_of(const MeshBox& from, const MeshBox& to, const MeshToView& to_view) {
    const auto low = [&](World Vec3<World>::*axis) { return std::min(from.mins.*axis, to.mins.*axis); };
    const auto high = [&](World Vec3<World>::*axis) { return std::max(from.maxs.*axis, to.maxs.*axis); };
    const auto middle = [&](World Vec3<World>::*axis) { return low(axis) + (high(axis) - low(axis)) / 2; };
    constexpr auto kX = &Vec3<World>::x, kY = &Vec3<World>::y, kZ = &Vec3<World>::z;
    const Vec3<World> place{middle(kX), middle(kY), middle(kZ)};
    const auto& [right, up, forward] = to_view.rows;
    const auto arm = [&, &right = right, &up = up, &forward = forward](World Vec3<World>::*axis, auto coefficient) {
        const World half = (high(axis) - low(axis)) / 2 + World::from_raw(2);  // what halves and vertices round
        const auto along = [&](const auto& row) { return convert<View>(widening_product(row.*coefficient, half)); };
        return Vec3<View>{along(right), along(up), along(forward)};
    };
    const auto along = [&](const auto& row, auto origin) { return convert<View>(dot(row, place) + origin); };
    using Row = Vec3<MeshToView::Coefficient>;
    return {{along(right, to_view.origin.x), along(up, to_view.origin.y), along(forward, to_view.origin.z)},
            {arm(kX, &Row::x), arm(kY, &Row::y), arm(kZ, &Row::z)}};
}

void view_vertex(const Vec3<World>& object_position, const MeshTransform& transform, const MeshToView& to_view,
                 const ViewContext& view, ViewVertex& seen) {
    bool is_inside = false;
    if (to_view.is_usable && is_small(object_position)) [[likely]] {
        const auto along = [&](const auto& row, auto origin) {
            return convert<View>(dot(row, object_position) + origin);
        };
        const auto& [right, up, forward] = to_view.rows;
        const auto& [x, y, z] = to_view.origin;
        seen.position = {along(right, x), along(up, y), along(forward, z)};
        const auto near = native::kHasShortRegisters ? to_short(seen.position) : std::nullopt;
        is_inside = near ? place_vertex_at(*near, view, seen) : place_vertex_at(seen.position, view, seen);
    } else {
        is_inside = place_vertex(world_position(object_position, transform), view, seen);
    }
    if (is_inside) seen.inverse_z = inverse_z_at(seen.position.z);
}

void clip_and_project(const std::array<const ViewVertex*, 3>& triangle,
                      const std::array<const CornerValues*, 3>& values, const ViewContext& view, ClipScratch& scratch,
                      std::vector<ScreenCorner>& polygon) {
    const ViewVertex *const a = triangle[0], *const b = triangle[1], *const c = triangle[2];
    polygon.clear();
    if ((a->outcode & b->outcode & c->outcode) != 0) return;
    const unsigned outcodes = a->outcode | b->outcode | c->outcode;
    if (outcodes == 0) {
        for (std::size_t i = 0; i < 3; ++i) polygon.push_back({*triangle[i], values[i] ? *values[i] : CornerValues{}});
        return;
    }
    const auto values_at = [&](const Vec3<View>& p) {
        return values[0] ? mixed(values, weights_at(p, a->position, b->position, c->position)) : CornerValues{};
    };
    scratch.polygon.clear();
    for (const ViewVertex* vertex : triangle) scratch.polygon.push_back({vertex->position, 0, vertex->outcode, 0});
    clip_polygon(view.frustum, outcodes, scratch);
    for (const ClipVertex& corner : scratch.polygon) {
        const ScreenVertex inside = to_screen_vertex(corner.position, view.projection, view.grid);
        polygon.push_back({{to_screen_border(inside, corner.borders, view.projection), inverse_z_at(corner.position.z)},
                           values_at(corner.position)});
    }
}

}  // namespace oblong
