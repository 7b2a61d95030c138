#pragma once

#include <optional>

#include "engine/math/plane.h"

namespace oblong {

/// The plane through a point with a normal.
constexpr Plane plane_through(const Vec3<World>& world_point, const Vec3<Unit>& normal) {
    return {normal, dot(world_point, normal)};
}

/// Where a line meets a plane.
struct LineHit {
    Vec3<World> world_point;
    Fixed<std::int64_t, 32> along;  ///< 0 at the line's start, 1 at its end; beyond them outside; saturates
};

/// Where the line through two points meets a plane (Abrash's LineIntersectPlane, corrected). A start in the plane is
/// returned unchanged; a line parallel to the plane, but not in it, has none. The point is rounded once, to the
/// nearest, and saturates.
std::optional<LineHit> intersect_line(const Vec3<World>& world_start, const Vec3<World>& world_end, const Plane& plane);

/// The same for the segment from start to end. An end in the plane counts as an intersection.
std::optional<LineHit> intersect_segment(const Vec3<World>& world_start, const Vec3<World>& world_end,
                                         const Plane& plane);

}  // namespace oblong
