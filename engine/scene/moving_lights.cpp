#include "engine/scene/moving_lights.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/fixed/root.h"
#include "engine/level/side.h"
#include "engine/math/soft_float.h"

namespace oblong {

namespace {

/// World's steps in 64 bits.
using Distance = WorldWide;
using DistanceSquare = Fixed<std::int64_t, 24>;
/// Vectors on a face, world units.
using OnFace = Fixed<std::int64_t, 24>;

constexpr std::int32_t kSampleStep = 16;  ///< texels from one light sample to the next

/// A light's distance in front of a face, and the texel nearest to it, counted from the first light sample.
struct LightAtFace {
    PlaneDistance distance;
    Texel u, v;
};

Vec3<World> in_model(const Vec3<World>& position, const Vec3<World>& offset) {
    return offset == Vec3<World>{} ? position : saturating_convert<World>(widening_difference(position, offset));
}

/// The texel that is nearest to a point at this distance from the plane.
Texel texel_below(const Vec3<TexelAxis>& axis, Texel offset, const LevelPlane& plane, const Vec3<World>& p,
                  PlaneDistance distance) {
    return texel_along(axis, p) + offset - product<Texel>(dot(axis, plane.normal), distance);
}

LightAtFace light_at_face(const Level& level, const Face& face, const Vec3<World>& p) {
    const LevelPlane& plane = level.planes[face.plane];
    const TexInfo& texinfo = level.texinfos[face.texinfo];
    const PlaneDistance distance = plane_distance(plane, p);
    return {face.is_back ? -distance : distance,
            texel_below(texinfo.s, texinfo.s_offset, plane, p, distance) - Texel::from_int(face.texel_min_u),
            texel_below(texinfo.t, texinfo.t_offset, plane, p, distance) - Texel::from_int(face.texel_min_v)};
}

/// The step on a face from one texel to the next, in world units.
using TexelWay = std::array<SoftFloat, 3>;
struct TexelWays {
    TexelWay u, v;
};

/// Solves s . u = t . v = 1 and s . v = t . u = n . u = n . v = 0. None if the axes are parallel on the plane.
std::optional<TexelWays> texel_ways(const LevelPlane& plane, const TexInfo& texinfo) {
    const auto u = cross(texinfo.t, plane.normal), v = cross(plane.normal, texinfo.s);
    WideSum sum;
    sum.add_product(texinfo.s.x, u.x);
    sum.add_product(texinfo.s.y, u.y);
    sum.add_product(texinfo.s.z, u.z);
    const SoftFloat volume = sum.scaled(-TexelAxis::kFractionBits - decltype(u.x)::kFractionBits);
    if (volume.is_zero()) return std::nullopt;
    const auto divided = [&volume](const auto& way) {
        return TexelWay{SoftFloat::from(way.x) / volume, SoftFloat::from(way.y) / volume,
                        SoftFloat::from(way.z) / volume};
    };
    return TexelWays{divided(u), divided(v)};
}

/// u across + v down, if each part is below 2^26 units.
std::optional<Vec3<OnFace>> on_face(const TexelWays& ways, Texel u, Texel v) {
    constexpr auto kMost = OnFace::from_int(1 << 26);
    std::array<OnFace, 3> parts;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const SoftFloat part = ways.u[axis] * SoftFloat::from(u) + ways.v[axis] * SoftFloat::from(v);
        const std::optional<OnFace> fixed = fixed_of<OnFace>(part);
        if (!fixed || absolute(*fixed) >= kMost) return std::nullopt;
        parts[axis] = *fixed;
    }
    return Vec3<OnFace>{parts[0], parts[1], parts[2]};
}

/// The first light sample, from the point of the face's plane nearest to the light, and the steps to the next column
/// and row.
struct SampleGrid {
    Vec3<OnFace> first, column, row;
};

std::optional<SampleGrid> sample_grid(const TexelWays& ways, const LightAtFace& light) {
    const auto first = on_face(ways, -light.u, -light.v);
    const auto column = on_face(ways, Texel::from_int(kSampleStep), Texel{});
    const auto row = on_face(ways, Texel{}, Texel::from_int(kSampleStep));
    if (!first || !column || !row) return std::nullopt;
    return SampleGrid{*first, *column, *row};
}

/// What a light adds to a sample at `way` from the point nearest to it; 8 fraction bits. `square` is its distance from
/// the plane, squared. With a radius below 2^23 steps, squares stay below 2^48.
std::int32_t light_at(const Vec3<OnFace>& way, DistanceSquare square, Distance radius, std::int32_t brightness_256) {
    for (const OnFace part : {way.x, way.y, way.z}) {
        const auto distance = convert<Distance>(part);
        if (absolute(distance) >= radius) return 0;
        square += bounded_product(distance, distance);
    }
    const auto distance = Distance::from_raw(integer_root(square.bits()));
    if (distance >= radius) return 0;
    return static_cast<std::int32_t>(floor_of((radius - distance) * brightness_256));
}

void add_samples(const SampleGrid& grid, PlaneDistance distance, const MovingLight& light, std::int32_t columns,
                 std::span<std::int32_t> samples_8) {
    const auto height = convert<Distance>(distance);
    const auto radius = convert<Distance>(light.radius);
    Vec3<OnFace> row_start = grid.first;
    for (; !samples_8.empty(); samples_8 = samples_8.subspan(as_size(columns))) {
        Vec3<OnFace> way = row_start;
        for (std::int32_t column = 0; column < columns; ++column) {
            item(samples_8, column) += light_at(way, bounded_product(height, height), radius, light.brightness_256);
            way = way + grid.column;
        }
        row_start = row_start + grid.row;
    }
}

/// Sorts lights: distance from the eye minus radius, with 8 fraction bits, then the light's index.
using RankedLight = std::pair<std::int64_t, std::size_t>;

RankedLight rank_of(const MovingLight& light, std::size_t index, const Vec3<World>& eye) {
    // In 1/256 unit, so that the square of any distance fits.
    const auto square = [](Distance way) { return floor_of<8>(way) * floor_of<8>(way); };
    const Vec3<Distance> way = widening_difference(light.position, eye);
    const auto squared = static_cast<std::uint64_t>(square(way.x) + square(way.y) + square(way.z));
    return {std::int64_t{integer_root(squared)} - floor_of<8>(light.radius), index};
}

/// The light, clamped to the limits; none if it gives no light.
std::optional<MovingLight> limited(MovingLight light) {
    if (light.radius <= World{} || light.brightness_256 <= 0) return std::nullopt;
    light.radius = std::min(light.radius, kMostLightRadius);
    light.brightness_256 = std::min(light.brightness_256, kMostBrightness_256);
    return light;
}

/// Whether a light within `strays` of its position may reach the front of a face, its model moved by `offset`: most are
/// too far from its plane.
bool touches(const MovingLight& light, World strays, const Level& level, const Face& face, TexelDensity density,
             const Vec3<World>& offset) {
    const Vec3<World> position = in_model(light.position, offset);
    const PlaneDistance distance = distance_before(level.planes[face.plane], face.is_back, position);
    const World radius = light.radius + strays;
    if (distance <= -convert<PlaneDistance>(strays) || convert<Distance>(distance) >= convert<Distance>(radius))
        return false;
    const LightAtFace seen = light_at_face(level, face, position);
    const Texel reach = product<Texel>(radius, density + TexelDensity::ulp());
    return seen.u > -reach && seen.u < Texel::from_int(face.texel_extent_u) + reach && seen.v > -reach &&
           seen.v < Texel::from_int(face.texel_extent_v) + reach;
}

template <class Visit>
void for_each_bit(std::uint32_t bits, Visit visit) {
    for (; bits != 0; bits &= bits - 1) visit(std::countr_zero(bits));
}

}  // namespace

void MovingLights::choose(std::span<const MovingLight> lights, const Vec3<World>& eye) {
    std::array<RankedLight, kMost> heap;  // the farthest chosen light first
    std::size_t count = 0;
    for (std::size_t index = 0; index < lights.size(); ++index) {
        const std::optional<MovingLight> light = limited(lights[index]);
        if (!light) continue;
        const RankedLight candidate = rank_of(*light, index, eye);
        if (count == kMost) {
            if (candidate > heap.front()) continue;
            std::pop_heap(heap.begin(), heap.end());
            --count;
        }
        item(heap, count++) = candidate;
        std::push_heap(heap.begin(), heap.begin() + static_cast<std::ptrdiff_t>(count));
    }
    chosen_.clear();
    for (const RankedLight& candidate : std::span(heap).first(count))
        chosen_.push_back(*limited(lights[candidate.second]));
}

/// Chosen lights that are known and unchanged, also from earlier frames, keep their slots and leave `chosen_`.
void MovingLights::keep_known() {
    active_ = 0;
    std::erase_if(chosen_, [&](const MovingLight& light) {
        for (int i = 0; i < kMost; ++i) {
            const std::uint32_t bit = std::uint32_t{1} << i;
            if ((active_ & bit) != 0 || item(known_, i).version == 0 || item(known_, i).light != light) continue;
            active_ |= bit;
            return true;
        }
        return false;
    });
}

void MovingLights::add_new() {
    for (const MovingLight& light : chosen_) {
        const int free = std::countr_one(active_);
        item(known_, free) = {light, ++version_};
        active_ |= std::uint32_t{1} << free;
    }
}

void MovingLights::set(std::span<const MovingLight> lights, const Vec3<World>& eye) {
    choose(lights, eye);
    keep_known();
    add_new();
}

bool may_touch(const MovingLight& light, World strays, const Level& level, FaceIndex face, const FaceTable& faces) {
    const std::optional<MovingLight> given = limited(light);
    return given && touches(*given, strays, level, level.faces[face], convert<TexelDensity>(faces[face].density), {});
}

MovingLights::FaceTouch& MovingLights::last_touch(FaceIndex face) {
    if (touch_of_.empty()) touch_of_.resize(level_.faces.size(), Index<FaceTouch>::none());
    Index<FaceTouch>& known = touch_of_[face];
    if (known.is_none()) {
        known = Index<FaceTouch>(touches_.count());
        touches_.push_back({});
    }
    return touches_[known];
}

LightTouch MovingLights::touch(FaceIndex index, const Vec3<World>& offset) {
    const Face& face = level_.faces[index];
    FaceTouch now;
    for_each_bit(active_, [&](int light) {
        const Known& known = item(known_, light);
        if (!touches(known.light, World{}, level_, face, convert<TexelDensity>(faces_[index].density), offset)) return;
        now.lights |= std::uint32_t{1} << light;
        now.newest = std::max(now.newest, known.version);
    });
    if (now.lights == 0) return {};
    FaceTouch& last = last_touch(index);
    if (last.lights != now.lights || last.newest != now.newest || last.offset != offset)
        last = {now.lights, last.version + 1, now.newest, offset};
    return {last.lights, last.version};
}

void MovingLights::add_light(FaceIndex index, const Vec3<World>& offset, std::uint32_t lights,
                             std::span<std::int32_t> samples_8) const {
    const Face& face = level_.faces[index];
    const auto ways = texel_ways(level_.planes[face.plane], level_.texinfos[face.texinfo]);
    if (!ways) return;
    for_each_bit(lights, [&](int number) {
        const MovingLight& light = item(known_, number).light;
        const LightAtFace seen = light_at_face(level_, face, in_model(light.position, offset));
        if (const std::optional<SampleGrid> grid = sample_grid(*ways, seen))
            add_samples(*grid, seen.distance, light, face.sample_columns(), samples_8);
    });
}

}  // namespace oblong
