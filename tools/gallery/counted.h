#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "engine/fixed/arithmetic.h"
#include "engine/math/vec.h"

namespace oblong {

/// The operations of a computation. A subtraction counts as an addition; signs, shifts and comparisons do not count.
struct CountedOperations {
    std::int64_t multiplications = 0, divisions = 0, additions = 0;
    bool operator==(const CountedOperations&) const = default;

    std::string text() const {
        return std::to_string(multiplications) + " * " + std::to_string(divisions) + " / " + std::to_string(additions) +
               " +";
    }
};

/// The counter of this thread's operations; null: not counted.
inline thread_local CountedOperations* counted_operations = nullptr;

/// The operations of a computation with Counted numbers.
template <class Compute>
CountedOperations operations_of(const Compute& compute) {
    CountedOperations operations;
    counted_operations = &operations;
    compute();
    counted_operations = nullptr;
    return operations;
}

/// A number that counts its operations.
template <class Value>
class Counted {
  public:
    constexpr Counted(Value value) : value_(value) {}

    Counted operator+(Counted other) const { return noted(&CountedOperations::additions, value_ + other.value_); }
    Counted operator-(Counted other) const { return noted(&CountedOperations::additions, value_ - other.value_); }
    Counted operator*(Counted other) const { return noted(&CountedOperations::multiplications, value_ * other.value_); }
    Counted operator/(Counted other) const { return noted(&CountedOperations::divisions, value_ / other.value_); }
    Counted operator>>(int bits) const { return floor_shift(value_, bits); }
    bool operator<(Counted other) const { return value_ < other.value_; }

  private:
    static Counted noted(std::int64_t CountedOperations::*kind, Value value) {
        if (counted_operations) ++(counted_operations->*kind);
        return value;
    }

    Value value_;
};

// The seeds' formulas for any number type, as corrected: y grows upward, rows downward.

template <class Number>
struct SeedPixel {
    Number x, y;
};

/// Muratori's first projection, for square pixels: d x / z + w / 2, and the same for y.
template <class Number>
SeedPixel<Number> project_naively(const Vec3<Number>& p, Number d, const SeedPixel<Number>& centre) {
    return {d * p.x / p.z + centre.x, centre.y - d * p.y / p.z};
}

/// His second, as written: with d r h / w for y, computed for each point. `r` is the display's shape.
template <class Number>
SeedPixel<Number> project_by_formula(const Vec3<Number>& p, Number d, Number r, const SeedPixel<Number>& size,
                                     const SeedPixel<Number>& centre) {
    return {d * p.x / p.z + centre.x, centre.y - d * (r * size.y / size.x) * p.y / p.z};
}

/// His last: the factor in parentheses is computed once for a mode.
template <class Number>
SeedPixel<Number> project_by_multipliers(const Vec3<Number>& p, const SeedPixel<Number>& multipliers,
                                         const SeedPixel<Number>& centre) {
    return {multipliers.x * p.x / p.z + centre.x, centre.y - multipliers.y * p.y / p.z};
}

template <class Number>
Number dot_by_components(const Vec3<Number>& u, const Vec3<Number>& v) {
    return u.x * v.x + u.y * v.y + u.z * v.z;
}

/// Abrash's example 3 (c), without the sign: a light on a surface.
template <class Number>
Number lit(const Vec3<Number>& normal, const Vec3<Number>& to_light, Number light) {
    return dot_by_components(normal, to_light) * light;
}

/// The whole cross product, and the third part of it, whose sign says which way a face on the screen looks.
template <class Number>
Number cross_z(const Vec3<Number>& u, const Vec3<Number>& v) {
    return u.x * v.y - u.y * v.x;
}
template <class Number>
Vec3<Number> cross_by_components(const Vec3<Number>& u, const Vec3<Number>& v) {
    return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, cross_z(u, v)};
}

/// Rotation by projection: three dot products.
template <class Number>
Vec3<Number> rotate_by_projection(const Vec3<Number>& p, const std::array<Vec3<Number>, 3>& axes) {
    return {dot_by_components(p, axes[0]), dot_by_components(p, axes[1]), dot_by_components(p, axes[2])};
}

/// The dot product in a basis that need not be orthonormal: nine terms, each with the dot product of two axes.
template <class Vector, class Dots>
auto dot_by_nine_terms(const Vector& u, const Vector& v, const Dots& axes) {
    return u.x * v.x * axes[0][0] + u.y * v.x * axes[1][0] + u.z * v.x * axes[2][0] +  //
           u.x * v.y * axes[0][1] + u.y * v.y * axes[1][1] + u.z * v.y * axes[2][1] +  //
           u.x * v.z * axes[0][2] + u.y * v.z * axes[1][2] + u.z * v.z * axes[2][2];
}

}  // namespace oblong
