#pragma once

#include <cmath>
#include <cstdint>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"
#include "tools/measure/exact.h"

/// The engine's numbers, points and directions in doubles, for the tests' own arithmetic. A World coordinate is exact
/// there.
namespace oblong::test {

using Point = reference::Vec;

inline Point along(const Point& a, const Point& b, double t) {
    return a + (b - a) * t;
}

/// The engine's number nearest to a value.
template <class Number>
Number nearest(double value) {
    return Number::from_raw(static_cast<typename Number::Raw>(std::llround(std::ldexp(value, Number::kFractionBits))));
}
inline Vec3<World> to_world(Point p) {
    return {nearest<World>(p.x), nearest<World>(p.y), nearest<World>(p.z)};
}
inline Vec3<World> point_at(double x, double y, double z) {
    return to_world({x, y, z});
}
template <class Int, int Frac>
Point to_point(const Vec3<Fixed<Int, Frac>>& p) {
    return vec_of(p);
}

}  // namespace oblong::test
