// Clipping to the four sides of random views. One plane at a time: HardCaseC1 to HardCaseC3.

#include "engine/view/clip.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <optional>

#include "engine/methods/axes.h"
#include "engine/methods/polygons.h"

namespace oblong::test {
namespace {

using ViewPoint = Vec3<View>;

/// Of a mode and a field of view, any that the engine takes.
Frustum any_frustum() {
    ScreenMode mode;
    mode.width_px = *rc::gen::inRange(16, 2'048);
    mode.height_px = *rc::gen::inRange(16, 2'048);
    const Degrees field_of_view = Degrees::from_int(*rc::gen::inRange(10, 170));
    return make_frustum(y_up_basis({}, {}, {}), make_projection(mode, field_of_view));
}

/// A point within `size` units of the eye along each axis, 2^-16 unit.
ViewPoint any_point(std::int64_t size) {
    const auto along = [size] { return View::from_raw(*rc::gen::inRange(-size * 65'536, size * 65'536)); };
    return {along(), along(), along()};
}

/// A point before the eye, in view or half as far beside it again; often in one of the side planes.
ViewPoint any_point_near_view(const Frustum& frustum, std::int64_t size) {
    const std::int64_t z_16 = *rc::gen::inRange<std::int64_t>(4, size * 65'536);
    const auto along = [z_16](const ClipPlane& plane, ClipNormal across) {
        const std::int64_t part_256 =
            *rc::gen::oneOf(rc::gen::inRange<std::int64_t>(-384, 385), rc::gen::element<std::int64_t>(-256, 256));
        return View::from_raw(z_16 * plane.normal.z.raw / across.raw * part_256 / 256);
    };
    const ClipPlane &left = frustum.clip_planes[0], &bottom = frustum.clip_planes[2];
    return {along(left, left.normal.x), along(bottom, bottom.normal.y), View::from_raw(z_16)};
}

/// Not each polygon's own outcodes: here positions alone say what is outside.
constexpr unsigned kAllPlanes = 15;

std::vector<ViewPoint> clipped(const Frustum& frustum, const std::vector<ViewPoint>& corners) {
    ClipScratch scratch;
    for (const ViewPoint& corner : corners) scratch.polygon.push_back({corner, 0});
    clip_polygon(frustum, kAllPlanes, scratch);
    std::vector<ViewPoint> left;
    for (const ClipVertex& vertex : scratch.polygon) left.push_back(vertex.position);
    return left;
}

/// What is left of an edge by itself: its part inside one plane after the other.
std::optional<std::array<ViewPoint, 2>> clipped_edge(const Frustum& frustum, ViewPoint a, ViewPoint b) {
    for (const ClipPlane& plane : frustum.clip_planes) {
        constexpr ClipDistance kOn{};
        const ClipDistance distance_a = plane.distance(a), distance_b = plane.distance(b);
        if (std::max(distance_a, distance_b) < kOn) return std::nullopt;
        if (distance_a < kOn) a = distance_b > kOn ? cross_plane(b, distance_b, a, distance_a) : b;
        if (distance_b < kOn) b = distance_a > kOn ? cross_plane(a, distance_a, b, distance_b) : a;
    }
    return std::array{a, b};
}

bool has(const std::vector<ViewPoint>& polygon, const ViewPoint& corner) {
    return std::find(polygon.begin(), polygon.end(), corner) != polygon.end();
}

RC_GTEST_PROP(PropertyClip, SharedEdgesAreCutAtTheSameBitsFromBothSides, ()) {
    const Frustum frustum = any_frustum();
    const std::int64_t size = *rc::gen::element(16, 900, 32'000);
    const ViewPoint a = any_point_near_view(frustum, size);
    const ViewPoint b = *rc::gen::arbitrary<bool>() ? any_point(size) : any_point_near_view(frustum, size);
    const auto edge = clipped_edge(frustum, a, b);
    const auto forth = clipped(frustum, {a, b, any_point(size)}), back = clipped(frustum, {b, a, any_point(size)});
    RC_PRE(edge.has_value());
    for (const ViewPoint& end : *edge) {
        RC_ASSERT(forth.empty() || has(forth, end));
        RC_ASSERT(back.empty() || has(back, end));
    }
}

/// As a frame clips: to the sides that the polygon's own corners are outside of.
std::vector<ClipVertex> clipped_as_in_a_frame(const Frustum& frustum, const std::vector<ViewPoint>& corners) {
    ClipScratch scratch;
    unsigned any_outside = 0, all_outside = 0xff;
    for (const ViewPoint& corner : corners) {
        const std::uint8_t outcode = outcode_of(frustum, corner);
        any_outside |= outcode;
        all_outside &= outcode;
        scratch.polygon.push_back({corner, 0, outcode, 0});
    }
    if (all_outside != 0) return {};
    if (any_outside != 0) clip_polygon(frustum, any_outside, scratch);
    return scratch.polygon;
}

/// An edge of a clipped polygon: where it begins and ends, and the borders that both ends are on.
using ClippedEdge = std::array<ViewPoint, 2>;

bool has_edge(const std::vector<ClipVertex>& polygon, const ClippedEdge& edge) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        if (polygon[i].position == edge[0] && polygon[(i + 1) % polygon.size()].position == edge[1]) return true;
    return false;
}

/// The edges within the view: those that clipping did not lay on a border.
std::vector<ClippedEdge> inner_edges(const std::vector<ClipVertex>& polygon) {
    std::vector<ClippedEdge> edges;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ClipVertex &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        if ((from.borders & to.borders) == 0 && from.position != to.position)
            edges.push_back({from.position, to.position});
    }
    return edges;
}

/// A tetrahedron is closed: clipped face by face, near the eye where positions are coarse, each edge in view is still
/// walked once forth and once back, bit for bit.
RC_GTEST_PROP(PropertyClip, ClosedSurfacesStayClosedWithinTheView, ()) {
    const Frustum frustum = any_frustum();
    const std::int64_t size_16 = *rc::gen::element<std::int64_t>(3, 8, 40, 900, 65'536, 20'000'000);
    const auto any_corner = [&] {
        const auto along = [&] { return View::from_raw(*rc::gen::inRange(-size_16, size_16 + 1)); };
        return ViewPoint{along(), along(), along()};
    };
    const ViewPoint a = any_corner(), b = any_corner(), c = any_corner(), d = any_corner();
    std::vector<std::vector<ClipVertex>> faces;
    for (const std::vector<ViewPoint>& corners : {std::vector{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}})
        faces.push_back(clipped_as_in_a_frame(frustum, corners));
    for (const auto& face : faces)
        for (const ClippedEdge& edge : inner_edges(face)) {
            const auto is_its_back = [&](const auto& other) { return has_edge(other, {edge[1], edge[0]}); };
            RC_ASSERT(std::any_of(faces.begin(), faces.end(), is_its_back));
        }
}

/// A part of the polygon's shadow along each axis, twice its area, (2^-16 unit)^2.
using Shadows = std::array<std::int64_t, 3>;

Shadows shadows_of(const std::vector<ClipVertex>& polygon) {
    Shadows sum{};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ViewPoint &a = polygon[i].position, &b = polygon[(i + 1) % polygon.size()].position;
        sum[0] += a.y.raw * b.z.raw - b.y.raw * a.z.raw;
        sum[1] += a.z.raw * b.x.raw - b.z.raw * a.x.raw;
        sum[2] += a.x.raw * b.y.raw - b.x.raw * a.y.raw;
    }
    return sum;
}

/// A bit in outcodes of which nothing is decided, so that positions say what is outside.
constexpr std::uint8_t kCut = 32;

std::vector<ClipVertex> part_of(const std::vector<ClipVertex>& polygon, const ClipPlane& plane) {
    std::vector<ClipVertex> part;
    if (polygon.size() >= 3) clip_to_plane(plane, kCut, polygon, part);
    return part;
}

ClipPlane reversed(const ClipPlane& plane) {
    return {-plane.normal, -plane.offset};
}

RC_GTEST_PROP(PropertyClip, WhatIsCutOffByEachPlaneAndWhatIsLeftAddUpToTheWhole, ()) {
    constexpr std::int64_t kSize = 900;
    const Frustum frustum = any_frustum();
    std::vector<ClipVertex> rest{{any_point(kSize), 0}, {any_point(kSize), 0}, {any_point(kSize), 0}};
    const Shadows whole = shadows_of(rest);
    Shadows sum{};
    const auto add = [&sum](const std::vector<ClipVertex>& part) {
        const Shadows shadows = shadows_of(part);
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += shadows[axis];
    };
    for (const ClipPlane& plane : frustum.clip_planes) {
        add(part_of(rest, reversed(plane)));
        rest = part_of(rest, plane);
    }
    add(rest);
    // Each plane makes two corners in each of two parts, rounded by half a step along two axes, where the polygon is
    // 2 * 900 units wide.
    constexpr std::int64_t kRounding = kClipPlaneCount * 4 * (2 * kSize * 65'536);
    for (std::size_t axis = 0; axis < 3; ++axis) RC_ASSERT(std::abs(sum[axis] - whole[axis]) <= kRounding);
}

}  // namespace
}  // namespace oblong::test
