#pragma once

#include <cmath>
#include <cstdint>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"
#include "tools/measure/exact.h"

/// The engine's points and directions in doubles, for the tests' own arithmetic. A World coordinate is exact there.
namespace oblong::test {

using Point = reference::Vec;

inline Point along(const Point& a, const Point& b, double t) {
    return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t};
}

inline Vec3<World> to_world(Point p) {
    const auto part = [](double value) {
        return World::from_raw(static_cast<std::int32_t>(std::lround(value * 4096)));
    };
    return {part(p.x), part(p.y), part(p.z)};
}
template <class Int, int Frac>
Point to_point(const Vec3<Fixed<Int, Frac>>& p) {
    return vec_of(p);
}

}  // namespace oblong::test
