#pragma once

namespace oblong {

/// Three numbers of one format: a point or a direction. Which space it is in stands in the variable's name.
template <class T>
struct Vec3 {
    T x{}, y{}, z{};

    constexpr Vec3 operator-() const { return {-x, -y, -z}; }
    constexpr Vec3 operator+(const Vec3& other) const { return {x + other.x, y + other.y, z + other.z}; }
    constexpr Vec3 operator-(const Vec3& other) const { return {x - other.x, y - other.y, z - other.z}; }
    constexpr bool operator==(const Vec3&) const = default;
};

}  // namespace oblong
