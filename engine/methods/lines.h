#pragma once

#include <cstdint>
#include <optional>

#include "engine/math/vec.h"
#include "engine/view/clip.h"

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

/// Two bits beside those of Outcode for the sides.
inline constexpr unsigned kOutFront = 16, kOutBack = 32;

/// A bit for each plane of the volume that a point in viewspace is outside of; a point on a plane is inside.
unsigned outcode_of(const ViewVolume& volume, const Vec3<View>& p);

enum class LineClipping : std::uint8_t {
    CohenSutherland,  ///< an outcode for each end; the line is cut at one plane after the other, and rounded at each
    LiangBarsky       ///< clip_line() of engine/view
};

/// The part of a line in the volume; none if there is none. Cohen and Sutherland: Newman and Sproull, "Principles of
/// Interactive Computer Graphics".
std::optional<ViewLine> clip_line(const ViewVolume& volume, const ViewLine& line, LineClipping method);

}  // namespace oblong
