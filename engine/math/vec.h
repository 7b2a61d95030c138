#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/fixed.h"

namespace oblong {

/// A point or a direction. The variable's name says in which space.
template <class T>
struct Vec3 {
    T x{}, y{}, z{};

    constexpr Vec3 operator-() const { return {-x, -y, -z}; }
    constexpr Vec3 operator+(const Vec3& other) const { return {x + other.x, y + other.y, z + other.z}; }
    constexpr Vec3 operator-(const Vec3& other) const { return {x - other.x, y - other.y, z - other.z}; }
    constexpr bool operator==(const Vec3&) const = default;
};

/// Converts each component to another format; it must fit.
template <class To, class Int, int Frac>
constexpr Vec3<To> convert(const Vec3<Fixed<Int, Frac>>& v, Rounding rounding = Rounding::NearestHalfUp) {
    return {convert<To>(v.x, rounding), convert<To>(v.y, rounding), convert<To>(v.z, rounding)};
}

/// The same; saturates.
template <class To, class Int, int Frac>
constexpr Vec3<To> saturating_convert(const Vec3<Fixed<Int, Frac>>& v) {
    return {saturating_convert<To>(v.x), saturating_convert<To>(v.y), saturating_convert<To>(v.z)};
}

/// Rounds each component to fewer fraction bits.
template <class T>
constexpr Vec3<T> rounded_to(const Vec3<T>& v, int fraction_bits) {
    return {rounded_to(v.x, fraction_bits), rounded_to(v.y, fraction_bits), rounded_to(v.z, fraction_bits)};
}

/// a - b in 64 bits.
template <class Int, int Frac>
constexpr auto widening_difference(const Vec3<Fixed<Int, Frac>>& a, const Vec3<Fixed<Int, Frac>>& b) {
    return Vec3<Fixed<std::int64_t, Frac>>{widening_difference(a.x, b.x), widening_difference(a.y, b.y),
                                           widening_difference(a.z, b.z)};
}

/// from + (to - from) part / whole, each coordinate rounded once; saturates.
template <class Int, int Frac, class Part>
constexpr auto between(const Vec3<Fixed<Int, Frac>>& from, const Vec3<Fixed<Int, Frac>>& to, Part part, Part whole) {
    return Vec3<Fixed<Int, Frac>>{between(from.x, to.x, part, whole), between(from.y, to.y, part, whole),
                                  between(from.z, to.z, part, whole)};
}

/// The exact dot product, in 64 bits (Muratori: |a| |b| cos of the angle between them, if the axes are at right angles
/// and of equal length). Unit times Unit gives 4.60, World times Unit PlaneDistance. The result must fit: by Cauchy's
/// inequality it does for any world position and a unit vector, and for world positions within +-2^17 units of each
/// other; then intermediate sums fit too.
template <class A, int FracA, class B, int FracB>
constexpr auto dot(const Vec3<Fixed<A, FracA>>& a, const Vec3<Fixed<B, FracB>>& b) {
    return bounded_product(a.x, b.x) + bounded_product(a.y, b.y) + bounded_product(a.z, b.z);
}

/// The exact cross product: at right angles to both, of length |a| |b| sin of the angle between them. x cross y = z in
/// both right-handed and left-handed axes. The same bounds as for dot().
template <class A, int FracA, class B, int FracB>
constexpr auto cross(const Vec3<Fixed<A, FracA>>& a, const Vec3<Fixed<B, FracB>>& b) {
    using Product = Fixed<std::int64_t, FracA + FracB>;
    return Vec3<Product>{widening_product(a.y, b.z) - widening_product(a.z, b.y),
                         widening_product(a.z, b.x) - widening_product(a.x, b.z),
                         widening_product(a.x, b.y) - widening_product(a.y, b.x)};
}

template <class Int, int Frac>
constexpr std::array<std::int64_t, 3> raw_of(const Vec3<Fixed<Int, Frac>>& v) {
    return {v.x.raw, v.y.raw, v.z.raw};
}

/// The length of a vector of any format, floored, in steps of that format.
std::uint64_t length_of_raw(const std::array<std::int64_t, 3>& vector);

/// The vector normalised to length 1, each component within 0.51 steps of 2^-30. The raw numbers may have any common
/// format. The zero vector stays zero.
std::array<Unit, 3> normalised_raw(const std::array<std::int64_t, 3>& vector);
std::array<Unit, 4> normalised_raw(const std::array<std::int64_t, 4>& vector);

template <class Int, int Frac>
Vec3<Unit> normalised(const Vec3<Fixed<Int, Frac>>& vector) {
    const auto unit = normalised_raw(raw_of(vector));
    return {unit[0], unit[1], unit[2]};
}

/// The length in the vector's format, floored.
template <class Int, int Frac>
Fixed<std::int64_t, Frac> length(const Vec3<Fixed<Int, Frac>>& vector) {
    static_assert(sizeof(Int) <= 4, "a length of 64-bit numbers may need 65 bits");
    const std::uint64_t raw = length_of_raw(raw_of(vector));
    return Fixed<std::int64_t, Frac>::from_raw(static_cast<std::int64_t>(raw));
}

/// Some vector of length 1 at right angles to `direction`; +x for the zero vector.
Vec3<Unit> perpendicular_to(const Vec3<Unit>& direction);

/// The mean of points, rounded once. At least one.
Vec3<World> middle_of(std::span<const Vec3<World>> points);

/// normal . p = distance; the normal has length 1 and points to the front.
struct Plane {
    Vec3<Unit> normal;
    PlaneDistance distance;
};

/// The exact distance of a point in front of the plane; negative behind it (Abrash: a dot product with the normal).
constexpr PlaneDistance distance_to_plane(const Vec3<World>& world_point, const Plane& plane) {
    return dot(world_point, plane.normal) - plane.distance;
}

/// A distance along a ray, units: 40.24.
using RayDistance = Fixed<std::int64_t, 24>;

/// The distance at which a ray meets a plane, within 2^-24 of the quotient; negative behind the origin. None if the ray
/// is parallel to the plane. `direction` has length 1. Saturates.
std::optional<RayDistance> intersect_ray(const Vec3<World>& world_origin, const Vec3<Unit>& direction,
                                         const Plane& plane);
/// The point on a ray at a distance, rounded once; saturates.
Vec3<World> point_on_ray(const Vec3<World>& world_origin, const Vec3<Unit>& direction, RayDistance distance);

}  // namespace oblong
