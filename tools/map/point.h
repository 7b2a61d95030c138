#pragma once

#include <cmath>

#include "engine/math/vec.h"

namespace oblong::map {

/// A point or direction of the world in doubles, in world units: the compiler's arithmetic.
using Point = Vec3<double>;

inline double dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Point cross(const Point& a, const Point& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Point scaled(const Point& a, double factor) {
    return {a.x * factor, a.y * factor, a.z * factor};
}

inline double length(const Point& a) {
    return std::sqrt(dot(a, a));
}

/// Component 0, 1 or 2: x, y or z.
inline double component(const Point& a, int axis) {
    return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

inline double& component(Point& a, int axis) {
    return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

/// The unit vector along axis 0, 1 or 2.
inline Point axis_vector(int axis) {
    return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
}

}  // namespace oblong::map
