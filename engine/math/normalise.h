#pragma once

#include <array>
#include <cstdint>

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"

namespace oblong {

/// The length of a vector of any format, floored, in steps of that format.
std::uint64_t length_of_raw(const std::array<std::int64_t, 3>& vector);

/// A vector of this direction and length 1, each component within 0.51 steps of 2^-30. Only the direction counts, so
/// that raw numbers of any common format do. The zero vector has no direction and stays zero.
std::array<Unit, 3> normalised_raw(const std::array<std::int64_t, 3>& vector);
std::array<Unit, 4> normalised_raw(const std::array<std::int64_t, 4>& vector);

template <class Int, int Frac>
Vec3<Unit> normalised(const Vec3<Fixed<Int, Frac>>& vector) {
    const auto unit = normalised_raw(std::array<std::int64_t, 3>{vector.x.raw, vector.y.raw, vector.z.raw});
    return {unit[0], unit[1], unit[2]};
}

/// The length in the vector's own format, floored.
template <class Int, int Frac>
Fixed<std::int64_t, Frac> length(const Vec3<Fixed<Int, Frac>>& vector) {
    static_assert(sizeof(Int) <= 4, "a length of 64-bit numbers may need 65 bits");
    const std::uint64_t raw = length_of_raw({vector.x.raw, vector.y.raw, vector.z.raw});
    return Fixed<std::int64_t, Frac>::from_raw(static_cast<std::int64_t>(raw));
}

/// Some vector of length 1 at right angles to `direction`; +x for the zero vector.
Vec3<Unit> perpendicular_to(const Vec3<Unit>& direction);

}  // namespace oblong
