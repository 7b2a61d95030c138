#include "engine/methods/line_and_plane.h"

#include "engine/fixed/arithmetic.h"

namespace oblong {

std::optional<LineHit> intersect_line(const Vec3<World>& world_start, const Vec3<World>& world_end,
                                      const Plane& plane) {
    const PlaneDistance from_start = distance_to_plane(world_start, plane);
    if (from_start == PlaneDistance{}) return LineHit{world_start, {}};
    const PlaneDistance approach = from_start - distance_to_plane(world_end, plane);
    if (approach == PlaneDistance{}) return std::nullopt;
    return LineHit{between(world_start, world_end, from_start, approach),
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
