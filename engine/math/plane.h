#pragma once

#include <cstdint>
#include <optional>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"

namespace oblong {

/// normal . p = distance; the normal has length 1 and points to the front.
struct Plane {
    Vec3<Unit> normal;
    PlaneDistance distance;
};

/// The exact distance of a point in front of the plane; negative behind it (Abrash: a dot product with the normal).
constexpr PlaneDistance distance_to_plane(const Vec3<World>& world_point, const Plane& plane) {
    return dot(world_point, plane.normal) - plane.distance;
}

/// A distance along a ray, units: 40.24.
using RayDistance = Fixed<std::int64_t, 24>;

/// The distance at which a ray meets a plane, within 2^-24 of the quotient; negative behind the origin. None if the ray
/// is parallel to the plane. `direction` has length 1. Saturates.
std::optional<RayDistance> intersect_ray(const Vec3<World>& world_origin, const Vec3<Unit>& direction,
                                         const Plane& plane);
/// The point on a ray at a distance, rounded once; saturates.
Vec3<World> point_on_ray(const Vec3<World>& world_origin, const Vec3<Unit>& direction, RayDistance distance);

}  // namespace oblong
