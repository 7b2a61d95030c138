#pragma once

namespace oblong::reference {

/// Everything in this folder is written from the formulas alone, in doubles, and includes nothing of the engine: tests
/// compare the engine with it.
struct Vec {
    double x = 0, y = 0, z = 0;

    Vec operator+(const Vec& other) const { return {x + other.x, y + other.y, z + other.z}; }
    Vec operator-(const Vec& other) const { return {x - other.x, y - other.y, z - other.z}; }
    Vec operator*(double factor) const { return {x * factor, y * factor, z * factor}; }
};

inline double dot(const Vec& a, const Vec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vec cross(const Vec& a, const Vec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace oblong::reference
