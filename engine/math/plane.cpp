#include "engine/math/plane.h"

#include "engine/fixed/arithmetic.h"

namespace oblong {

std::optional<RayDistance> intersect_ray(const Vec3<World>& world_origin, const Vec3<Unit>& direction,
                                         const Plane& plane) {
    const Sine60 approach = -dot(direction, plane.normal);
    if (approach == Sine60{}) return std::nullopt;
    return divide<RayDistance>(distance_to_plane(world_origin, plane), approach);
}

Vec3<World> point_on_ray(const Vec3<World>& world_origin, const Vec3<Unit>& direction, RayDistance distance) {
    const auto along = [&distance](World from, Unit slope) {
        return saturated_to<World>(saturating_sum(from.raw, product<WorldWide>(slope, distance).raw));
    };
    return {along(world_origin.x, direction.x), along(world_origin.y, direction.y), along(world_origin.z, direction.z)};
}

}  // namespace oblong
