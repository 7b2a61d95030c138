#include "engine/math/plane.h"

#include "engine/fixed/arithmetic.h"

namespace oblong {

namespace {

/// start + (end - start) part / whole
World between(World start, World end, PlaneDistance part, PlaneDistance whole) {
    const std::int64_t step = mul_div(std::int64_t{end.raw} - start.raw, part.raw, whole.raw);
    return saturated_to<World>(saturating_sum(start.raw, step));
}

}  // namespace

std::optional<LineHit> intersect_line(const Vec3<World>& world_start, const Vec3<World>& world_end,
                                      const Plane& plane) {
    const PlaneDistance from_start = distance_to_plane(world_start, plane);
    if (from_start == PlaneDistance{}) return LineHit{world_start, {}};
    const PlaneDistance approach = from_start - distance_to_plane(world_end, plane);
    if (approach == PlaneDistance{}) return std::nullopt;
    return LineHit{{between(world_start.x, world_end.x, from_start, approach),
                    between(world_start.y, world_end.y, from_start, approach),
                    between(world_start.z, world_end.z, from_start, approach)},
                   divide<Fixed<std::int64_t, 32>>(from_start, approach)};
}

std::optional<LineHit> intersect_segment(const Vec3<World>& world_start, const Vec3<World>& world_end,
                                         const Plane& plane) {
    const PlaneDistance none{};
    const PlaneDistance from_start = distance_to_plane(world_start, plane);
    const PlaneDistance from_end = distance_to_plane(world_end, plane);
    if (from_start > none && from_end > none) return std::nullopt;
    if (from_start < none && from_end < none) return std::nullopt;
    return intersect_line(world_start, world_end, plane);
}

}  // namespace oblong
