#pragma once

#include <vector>

#include "tools/map/source/geometry.h"

namespace oblong::map {

/// A convex polygon in space, clockwise seen from the front of its plane; empty: nothing.
using Winding = std::vector<Point>;

/// Points nearer to a plane than this count as on it when polygons are cut.
inline constexpr double kOnEpsilon = 1.0 / 16384;

/// Half the width of the polygon that stands for a whole plane: more than any level.
inline constexpr double kHuge = 131072;

/// A square on the plane, of half width kHuge.
Winding whole_plane(const Plane& plane);

struct SplitWinding {
    Winding front, back;
    bool is_on = false;  ///< every point is on the plane: neither front nor back is set
};

/// Cuts by a plane. The new points come out the same to the bit for the two polygons at an edge, whichever way they
/// run.
SplitWinding split(const Winding& winding, const Plane& plane);

/// What is in front of the plane, or on it.
Winding clipped_to_front(const Winding& winding, const Plane& plane);

/// What is behind the plane, or on it.
inline Winding clipped_to_back(const Winding& winding, const Plane& plane) {
    return clipped_to_front(winding, plane.flipped());
}

/// How far the winding reaches in front of and behind the plane (both at least 0).
struct Reach {
    double front = 0, back = 0;
};
Reach reach(const Winding& winding, const Plane& plane);

Winding reversed(const Winding& winding);

/// A vector opposite to the facing direction (the polygon is clockwise) whose length is twice the area.
Point area_vector(const Winding& winding);

/// The distance of two parallel lines between which the polygon just fits, over all directions along its edges.
double least_width(const Winding& winding);

/// The mean of the points.
Point middle(const Winding& winding);

/// Joins convex polygons of one plane and one facing that share a whole edge, where the union is convex.
std::vector<Winding> merged(std::vector<Winding> windings);

}  // namespace oblong::map
