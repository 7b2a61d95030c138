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

/// The plane through a point with a normal.
constexpr Plane plane_through(const Vec3<World>& world_point, const Vec3<Unit>& normal) {
    return {normal, dot(world_point, normal)};
}

/// How far a point is in front of the plane, exact; negative behind it (Abrash: a dot product with the normal).
constexpr PlaneDistance distance_to_plane(const Vec3<World>& world_point, const Plane& plane) {
    return dot(world_point, plane.normal) - plane.distance;
}

/// Where a line meets a plane.
struct LineHit {
    Vec3<World> world_point;
    Fixed<std::int64_t, 32> along;  ///< 0 at the line's start, 1 at its end; beyond them outside; saturates
};

/// Where the line through two points meets a plane (Abrash's LineIntersectPlane, corrected). A start in the plane is
/// returned as it is; a line parallel to the plane and off it gives none. The point is rounded
/// once, to the nearest, and saturates.
std::optional<LineHit> intersect_line(const Vec3<World>& world_start, const Vec3<World>& world_end, const Plane& plane);

/// The same for the segment from start to end. An end in the plane counts as a meeting point.
std::optional<LineHit> intersect_segment(const Vec3<World>& world_start, const Vec3<World>& world_end,
                                         const Plane& plane);

/// A distance along a ray, units: 40.24.
using RayDistance = Fixed<std::int64_t, 24>;

/// How far from its origin a ray meets a plane, within 2^-24 of the quotient; below 0 behind the origin. None for a ray
/// parallel to the plane. `direction` has length 1. Saturates.
std::optional<RayDistance> intersect_ray(const Vec3<World>& world_origin, const Vec3<Unit>& direction,
                                         const Plane& plane);
/// The point of a ray at a distance, rounded once; saturates.
Vec3<World> point_on_ray(const Vec3<World>& world_origin, const Vec3<Unit>& direction, RayDistance distance);

}  // namespace oblong
