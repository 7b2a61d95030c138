#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "engine/base/table.h"

namespace oblong {

namespace detail {

inline constexpr int kLogarithmBits = 22;

constexpr std::uint64_t floor_of_root(std::uint64_t value) {
    std::uint64_t root = 0;
    for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1)
        if ((root + bit) * (root + bit) <= value) root += bit;
    return root;
}

/// 2^-(1/2), 2^-(1/4), 2^-(1/8) ..., each the square root of the previous one; 32 fraction bits.
inline constexpr auto kRootsOfHalf_32 = [] {
    std::array<std::uint32_t, kLogarithmBits> roots{};
    std::uint64_t root = std::uint64_t{1} << 31;
    for (std::uint32_t& entry : roots) entry = static_cast<std::uint32_t>(root = floor_of_root(root << 32));
    return roots;
}();

/// -log2 of a fraction above 0: each squaring doubles the logarithm and shifts out one of its bits.
constexpr std::uint64_t negative_logarithm_22(std::uint32_t base_30) {
    const int shift = std::countl_zero(base_30);
    std::uint32_t mantissa_31 = base_30 << shift, fraction = 0;
    for (int bit = 0; bit < kLogarithmBits; ++bit) {
        const std::uint64_t square_62 = std::uint64_t{mantissa_31} * mantissa_31;
        const auto overflow = static_cast<std::uint32_t>(square_62 >> 63);
        mantissa_31 = static_cast<std::uint32_t>(overflow != 0 ? square_62 >> 32 : square_62 >> 31);
        fraction = fraction << 1 | overflow;
    }
    return (static_cast<std::uint64_t>(shift - 1) << kLogarithmBits) - fraction;
}

constexpr std::uint32_t power_of_half_30(std::uint64_t exponent_22) {
    const std::uint64_t whole = exponent_22 >> kLogarithmBits;
    if (whole > 30) return 0;
    std::uint32_t power_31 = std::uint32_t{1} << 31;
    auto bits = static_cast<std::uint32_t>(exponent_22 << (32 - kLogarithmBits));  // of the fraction
    while (bits != 0) {
        const int first = std::countl_zero(bits);
        power_31 = static_cast<std::uint32_t>(std::uint64_t{power_31} * item(kRootsOfHalf_32, first) >> 32);
        bits ^= std::uint32_t{1} << 31 >> first;
    }
    return power_31 >> whole >> 1;
}

}  // namespace detail

/// base ^ (numerator / denominator); base and result have 30 fraction bits; error at most 2^-20 for exponents up to 3.
/// `base_30` is 0 to 2^30, numerator and denominator 1 to 2^20. 0 to any power is 0.
constexpr std::uint32_t power_30(std::uint32_t base_30, std::uint32_t numerator, std::uint32_t denominator) {
    if (base_30 == 0) return 0;
    return detail::power_of_half_30(detail::negative_logarithm_22(base_30) * numerator / denominator);
}

}  // namespace oblong
