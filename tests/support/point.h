#pragma once

#include <algorithm>
#include <cmath>

#include "engine/io/doubles.h"
#include "engine/math/vec.h"
#include "engine/measure/exact.h"

/// The engine's numbers, points and directions in doubles, for the tests' own arithmetic. A World coordinate is exact
/// there.
namespace oblong::test {

using Point = reference::Vec;

inline Point along(const Point& a, const Point& b, double t) {
    return a + (b - a) * t;
}

/// Where a ray from `from` along `ray` enters and leaves a box, in lengths of the ray; entry above exit: it misses.
struct BoxPassage {
    double entry = -INFINITY, exit = INFINITY;
};
inline BoxPassage passage_of(const Point& from, const Point& ray, const Point& mins, const Point& maxs) {
    BoxPassage passage;
    for (const int axis : {0, 1, 2}) {
        const double low = (mins[axis] - from[axis]) / ray[axis], high = (maxs[axis] - from[axis]) / ray[axis];
        passage.entry = std::max(passage.entry, std::min(low, high));
        passage.exit = std::min(passage.exit, std::max(low, high));
    }
    return passage;
}

inline Vec3<World> to_world(Point p) {
    return {fixed_of<World>(p.x), fixed_of<World>(p.y), fixed_of<World>(p.z)};
}
inline Vec3<World> point_at(double x, double y, double z) {
    return to_world({x, y, z});
}
template <class Int, int Frac>
Point to_point(const Vec3<Fixed<Int, Frac>>& p) {
    return vec_of(p);
}

}  // namespace oblong::test
