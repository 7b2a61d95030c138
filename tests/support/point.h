#pragma once

#include <cmath>
#include <cstdint>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"

/// World points in double, for the tests' own arithmetic. A World coordinate is exact in double.
namespace oblong::test {

struct Point {
    double x = 0, y = 0, z = 0;
};

inline double dot(Point a, Point b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Point along(Point a, Point b, double t) {
    return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t};
}

inline Vec3<World> to_world(Point p) {
    const auto part = [](double value) {
        return World::from_raw(static_cast<std::int32_t>(std::lround(value * 4096)));
    };
    return {part(p.x), part(p.y), part(p.z)};
}
inline Point to_point(Vec3<World> p) {
    return {p.x.raw / 4096., p.y.raw / 4096., p.z.raw / 4096.};
}

}  // namespace oblong::test
