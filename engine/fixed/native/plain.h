#pragma once

#include <compare>
#include <cstdint>

// What a processor of 32 bits does in one or two instructions and C++ has no words for, in plain C++: the reference for
// native code, and what all other processors run.

namespace oblong {

struct ShortDivision {
    std::uint32_t quotient = 0, remainder = 0;
};

/// high * 2^64 + low.
struct Uint128 {
    std::uint64_t high = 0, low = 0;
    constexpr auto operator<=>(const Uint128&) const = default;
};

/// high * 2^32 + low.
struct Int96 {
    std::int64_t high = 0;
    std::uint32_t low = 0;
};

/// The upper 32 bits of a number that was shifted to the left.
struct ShiftedUpper {
    std::uint32_t bits = 0;
    bool is_below_zero = false;
};

namespace plain {

/// Whether a number of 64 bits takes two registers, so that numbers which fit 32 bits are worth a test.
inline constexpr bool kHasShortRegisters = false;

/// The exact product. (A compiler that sees a factor as half of a number of 64 bits multiplies the whole number.)
constexpr std::int64_t product_to_64(std::int32_t a, std::int32_t b) {
    return std::int64_t{a} * b;
}
constexpr std::uint64_t product_to_64(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{a} * b;
}
constexpr Uint128 product_to_128(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t kHalf = 0xffffffff;
    const std::uint64_t low = (a & kHalf) * (b & kHalf);
    const std::uint64_t cross = (a >> 32) * (b & kHalf) + (low >> 32);
    const std::uint64_t middle = (a & kHalf) * (b >> 32) + (cross & kHalf);
    return {(a >> 32) * (b >> 32) + (cross >> 32) + (middle >> 32), (middle << 32) | (low & kHalf)};
}

/// value + step * count modulo 2^64.
constexpr std::uint64_t wrapping_sum(std::uint64_t value, std::uint64_t step, std::uint32_t count) {
    return value + step * count;
}

/// n / d with a quotient of 32 bits: n / 2^32 < d.
constexpr ShortDivision divide_to_32(std::uint64_t n, std::uint32_t d) {
    return {static_cast<std::uint32_t>(n / d), static_cast<std::uint32_t>(n % d)};
}

/// value / 2^shift, floored, modulo 2^64; `shift` 1 to 31.
constexpr std::int64_t shift_right(Int96 value, int shift) {
    const std::uint64_t lower = (static_cast<std::uint64_t>(value.high) << 32 | value.low) >> shift;
    const auto upper = static_cast<std::uint32_t>(value.high >> shift);
    return static_cast<std::int64_t>(std::uint64_t{upper} << 32 | static_cast<std::uint32_t>(lower));
}

/// value * 2^shift / 2^32, floored, modulo 2^32; `shift` 1 to 31.
constexpr ShiftedUpper shift_left(std::int64_t value, int shift) {
    const auto bits = static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) << shift >> 32);
    return {bits, bits >> 31 != 0};
}

/// size * (2^32 + 1 + above) modulo 2^64.
constexpr std::uint64_t product_above_one(std::uint32_t size, std::uint32_t above) {
    return (std::uint64_t{size} << 32) + size + product_to_64(size, above);
}

/// first <= value < first + count, modulo 2^32.
constexpr bool is_in_range(std::uint32_t value, std::uint32_t first, std::uint32_t count) {
    return value - first < count;
}

/// a * b / (2^8 d), rounded to nearest, halves up. Its magnitude is below 2^25, d below 2^30.
constexpr std::int32_t rounded_quotient_8(std::int32_t a, std::int32_t b, std::uint32_t d) {
    // 2^33 d is added, so that the division needs no sign, and taken from its result; all is below 2^64.
    const std::uint64_t n =
        static_cast<std::uint64_t>(product_to_64(a, b)) + std::uint64_t{d} * ((std::uint64_t{1} << 33) + (1 << 7));
    return static_cast<std::int32_t>(divide_to_32(n >> 8, d).quotient) - (1 << 25);
}

/// floor((factor * (high * 2^32 + low) + 2^47) / 2^48).
constexpr std::int64_t rounded_product_48(std::int32_t factor, std::int32_t low, std::int32_t high) {
    constexpr std::int64_t kHalf = std::int64_t{1} << 47;
    return (product_to_64(factor, high) + ((product_to_64(factor, low) + kHalf) >> 32)) >> 16;
}

}  // namespace plain
}  // namespace oblong
