#pragma once

#include <cmath>
#include <concepts>

/// Everything in this folder is written from the formulas, in doubles, without the engine's code: tests compare the
/// engine with it.
namespace oblong::reference {

/// A point or a direction in doubles: used by all tools and tests that compare with doubles.
struct Vec {
    double x = 0, y = 0, z = 0;

    constexpr Vec operator+(const Vec& other) const { return {x + other.x, y + other.y, z + other.z}; }
    constexpr Vec operator-(const Vec& other) const { return {x - other.x, y - other.y, z - other.z}; }
    constexpr Vec operator-() const { return {-x, -y, -z}; }
    constexpr Vec operator*(double factor) const { return {x * factor, y * factor, z * factor}; }
    constexpr bool operator==(const Vec&) const = default;

    /// Component 0, 1 or 2: x, y or z.
    constexpr double operator[](std::integral auto axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    constexpr double& operator[](std::integral auto axis) { return axis == 0 ? x : axis == 1 ? y : z; }
};

constexpr double dot(const Vec& a, const Vec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

constexpr Vec cross(const Vec& a, const Vec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(const Vec& a) {
    return std::sqrt(dot(a, a));
}

inline Vec normalised(const Vec& a) {
    const double size = length(a);
    return {a.x / size, a.y / size, a.z / size};
}

}  // namespace oblong::reference
