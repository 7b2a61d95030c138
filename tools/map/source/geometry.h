#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/table.h"
#include "engine/reference/vec.h"

namespace oblong::map {

/// A point or direction of the world in doubles, in world units: the compiler's arithmetic.
using Point = reference::Vec;

/// Between neighbours of a sunflower's spiral, whose points are spread evenly over a disc or a ball (Vogel 1979).
inline const double kGoldenAngle = std::numbers::pi * (3 - std::sqrt(5.0));

/// "x y z", with six digits each.
std::string point_text(const Point& point);

/// The size of the largest component.
inline double largest_component(const Point& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// A vector of the same direction and length 1; the zero vector stays.
inline Point unit(const Point& vector) {
    const double size = length(vector);
    return size == 0 ? vector : vector * (1 / size);
}

/// The unit vector along axis 0, 1 or 2.
inline Point axis_vector(int axis) {
    return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
}

/// An axis-aligned box; empty until a point is added.
struct Box {
    static constexpr double kFar = std::numeric_limits<double>::max();
    Point mins{kFar, kFar, kFar}, maxs{-kFar, -kFar, -kFar};

    bool is_empty() const { return mins.x > maxs.x; }

    void add(const Point& point) {
        for (int axis = 0; axis < 3; ++axis) {
            mins[axis] = std::min(mins[axis], point[axis]);
            maxs[axis] = std::max(maxs[axis], point[axis]);
        }
    }

    void add(std::span<const Point> points) {
        for (const Point& point : points) add(point);
    }

    void add(const Box& other) {
        if (other.is_empty()) return;
        add(other.mins);
        add(other.maxs);
    }

    /// The largest coordinate, with either sign.
    double largest_coordinate() const { return std::max(largest_component(mins), largest_component(maxs)); }

    /// This box with every side moved outward by `margin`.
    Box grown(double margin) const {
        const Point by{margin, margin, margin};
        return {mins - by, maxs + by};
    }

    /// Whether the boxes, each grown by half of `slack`, share a point.
    bool touches(const Box& other, double slack) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (mins[axis] > other.maxs[axis] + slack) return false;
            if (maxs[axis] < other.mins[axis] - slack) return false;
        }
        return true;
    }
};

inline Box box_of(std::span<const Point> points) {
    Box box;
    box.add(points);
    return box;
}

/// normal . p = distance; its front is where normal . p is larger.
struct Plane {
    Point normal;
    double distance = 0;

    double height_of(const Point& point) const { return dot(normal, point) - distance; }
    Plane flipped() const { return {-normal, -distance}; }
};

/// The corner of a box that is farthest along a direction.
inline Point farthest_corner(const Box& box, const Point& direction) {
    return {(direction.x > 0 ? box.maxs : box.mins).x, (direction.y > 0 ? box.maxs : box.mins).y,
            (direction.z > 0 ? box.maxs : box.mins).z};
}

/// Whether all of a box is on one side of a plane, at a distance far above all rounding.
inline bool is_clearly_behind(const Box& box, const Plane& plane) {
    return plane.height_of(farthest_corner(box, plane.normal)) < -1;
}
inline bool is_clearly_in_front(const Box& box, const Plane& plane) {
    return plane.height_of(farthest_corner({box.maxs, box.mins}, plane.normal)) > 1;
}

/// One side of a plane in a PlaneList: `is_back`: opposite to the normal.
struct PlaneSide {
    int plane = 0;
    bool is_back = false;

    auto operator<=>(const PlaneSide&) const = default;
};

/// All planes of a level, each once and with its longest component positive, so that equal planes have equal indices.
class PlaneList {
  public:
    /// The side equal to `plane` within kNormalEpsilon and kDistanceEpsilon; nearly axial normals become axial, with
    /// nearly whole distances rounded.
    PlaneSide find_or_add(const Plane& plane);

    const Plane& operator[](int index) const { return item(planes_, index); }
    /// The plane's kind in the level file: 0, 1, 2 if the normal is exactly +x, +y, +z, else 3 + its longest
    /// component's axis.
    int type(int index) const { return item(types_, index); }
    Plane facing(PlaneSide side) const { return side.is_back ? (*this)[side.plane].flipped() : (*this)[side.plane]; }
    int count() const { return static_cast<int>(planes_.size()); }

    static constexpr double kNormalEpsilon = 1e-6;
    static constexpr double kDistanceEpsilon = 1.0 / 512;

  private:
    std::vector<Plane> planes_;
    std::vector<int> types_;
    std::map<long, std::vector<int>> by_distance_;  // whole distance -> planes
};

/// A convex polygon in space, clockwise seen from the front of its plane; may be empty.
using Winding = std::vector<Point>;

/// When polygons are cut, points nearer to the plane than this are on it.
inline constexpr double kOnEpsilon = 1.0 / 16384;

/// Half the width of the polygon that represents a whole plane: larger than any level.
inline constexpr double kHuge = 131072;

/// A square on the plane, of half width kHuge.
Winding whole_plane(const Plane& plane);

struct SplitWinding {
    Winding front, back;
    bool is_on = false;  ///< every point is on the plane: `front` is the whole
};

/// Cuts by a plane. The new points are bit-identical for the two polygons at an edge, regardless of their directions.
SplitWinding split(Winding winding, const Plane& plane);

/// Keeps the part in front of the plane or on it; nothing of a polygon that is all on it, unless `keeps_on`. `spare`:
/// memory for reuse by the next cut.
void clip_to_front(Winding& winding, const Plane& plane, Winding& spare, bool keeps_on = true);

/// The winding's extents in front of and behind a plane (both at least 0).
struct Reach {
    double front = 0, back = 0;
};
Reach reach(const Winding& winding, const Plane& plane);

Winding reversed(const Winding& winding);

/// A vector opposite to the facing direction (the polygon is clockwise) whose length is twice the area.
Point area_vector(const Winding& winding);

/// The polygon's least width over the directions perpendicular to its edges.
double least_width(const Winding& winding);

/// The least and the greatest of the numbers at the points.
template <class NumberAt>
auto range_of(const Winding& winding, NumberAt number_at) {
    auto least = number_at(winding[0]), greatest = least;
    for (const Point& point : winding) {
        least = std::min(least, number_at(point));
        greatest = std::max(greatest, number_at(point));
    }
    return std::pair(least, greatest);
}

/// The mean of the points.
Point middle(const Winding& winding);

/// Joins convex polygons of the same plane and facing that share a whole edge, if the union is convex.
std::vector<Winding> merged(std::vector<Winding> windings);

}  // namespace oblong::map
