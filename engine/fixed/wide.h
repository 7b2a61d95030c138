#pragma once

#include <bit>
#include <compare>
#include <cstdint>
#include <limits>

#include "engine/fixed/fixed.h"

// 64-bit arithmetic whose intermediate results have 128 bits. Everything here is exact, rounded once by a named rule,
// and saturates with the right sign where the result does not fit. `portable` needs no 128-bit type and is always
// compiled; where the compiler has one, the functions below use it and equal `portable` for every input.

namespace oblong {

namespace detail {

/// |value|, also for the lowest one.
constexpr std::uint64_t magnitude(std::int64_t value) {
    const auto bits = static_cast<std::uint64_t>(value);
    return value < 0 ? 0 - bits : bits;
}

/// The number of this sign and magnitude; saturates.
constexpr std::int64_t saturated(bool is_negative, std::uint64_t size) {
    constexpr std::uint64_t kEnd = std::uint64_t{1} << 63;
    if (is_negative) return size >= kEnd ? std::numeric_limits<std::int64_t>::min() : -static_cast<std::int64_t>(size);
    return size >= kEnd ? std::numeric_limits<std::int64_t>::max() : static_cast<std::int64_t>(size);
}

/// Whether a truncated magnitude must be increased by 1; `against_half` compares the dropped fraction with 1/2.
constexpr bool rounds_away(bool is_negative, bool is_exact, std::strong_ordering against_half, Rounding rounding) {
    if (rounding == Rounding::Floor) return is_negative && !is_exact;
    return against_half > 0 || (against_half == 0 && !is_negative);
}

/// Division by zero: the lowest or highest value, by the numerator's sign; 0 / 0 is 0.
constexpr std::int64_t divided_by_zero(bool is_negative, bool is_zero) {
    return is_zero ? 0 : saturated(is_negative, ~std::uint64_t{0});
}

}  // namespace detail

namespace portable {

/// high * 2^64 + low.
struct Uint128 {
    std::uint64_t high = 0, low = 0;
    constexpr auto operator<=>(const Uint128&) const = default;
};

/// The exact product, from four products of halves.
constexpr Uint128 multiply(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t kHalf = 0xffffffff;
    const std::uint64_t low = (a & kHalf) * (b & kHalf);
    const std::uint64_t cross = (a >> 32) * (b & kHalf) + (low >> 32);
    const std::uint64_t middle = (a & kHalf) * (b >> 32) + (cross & kHalf);
    return {(a >> 32) * (b >> 32) + (cross >> 32) + (middle >> 32), (middle << 32) | (low & kHalf)};
}

/// a + b modulo 2^128.
constexpr Uint128 add(Uint128 a, Uint128 b) {
    const std::uint64_t low = a.low + b.low;
    return {a.high + b.high + (low < a.low ? 1 : 0), low};
}

struct Division {
    std::uint64_t quotient = 0, remainder = 0;
};

/// n / d where n.high < d, so that the quotient fits: binary long division.
constexpr Division divide(Uint128 n, std::uint64_t d) {
    Division result{0, n.high};
    for (int bit = 63; bit >= 0; --bit) {
        const bool carry = (result.remainder >> 63) != 0;
        result.remainder = (result.remainder << 1) | ((n.low >> bit) & 1);
        if (!carry && result.remainder < d) continue;
        result.remainder -= d;
        result.quotient |= std::uint64_t{1} << bit;
    }
    return result;
}

/// a * b / c. See oblong::mul_div.
constexpr std::int64_t mul_div(std::int64_t a, std::int64_t b, std::int64_t c, Rounding rounding) {
    const bool is_negative = ((a < 0) != (b < 0)) != (c < 0);
    const Uint128 product = multiply(detail::magnitude(a), detail::magnitude(b));
    const std::uint64_t divisor = detail::magnitude(c);
    if (divisor == 0) return detail::divided_by_zero(is_negative, product == Uint128{});
    if (product.high >= divisor) return detail::saturated(is_negative, ~std::uint64_t{0});
    const auto [quotient, remainder] = divide(product, divisor);
    const bool away = detail::rounds_away(is_negative, remainder == 0, remainder <=> divisor - remainder, rounding);
    return detail::saturated(is_negative, away && quotient + 1 != 0 ? quotient + 1 : quotient);
}

/// The bits of `value` below bit `shift` (1 to 126), compared with half of that bit.
constexpr std::strong_ordering rest_against_half(Uint128 value, int shift) {
    const int half = shift - 1;
    if (half >= 64) {
        const std::uint64_t bit = std::uint64_t{1} << (half - 64);
        return Uint128{value.high & (2 * bit - 1), value.low} <=> Uint128{bit, 0};
    }
    const std::uint64_t bit = std::uint64_t{1} << half;
    return (value.low & (2 * bit - 1)) <=> bit;
}

/// value >> shift, `shift` 0 to 126.
constexpr Uint128 shift_right(Uint128 value, int shift) {
    if (shift == 0) return value;
    if (shift >= 64) return {0, value.high >> (shift - 64)};
    return {value.high >> shift, (value.high << (64 - shift)) | (value.low >> shift)};
}

/// a * b / 2^shift. See oblong::mul_shift.
constexpr std::int64_t mul_shift(std::int64_t a, std::int64_t b, int shift, Rounding rounding) {
    const bool is_negative = (a < 0) != (b < 0);
    const Uint128 product = multiply(detail::magnitude(a), detail::magnitude(b));
    const Uint128 kept = shift_right(product, shift);
    if (kept.high != 0) return detail::saturated(is_negative, ~std::uint64_t{0});
    if (shift == 0) return detail::saturated(is_negative, kept.low);
    const bool is_exact =
        std::countr_zero(product.low) >= shift || (product.low == 0 && 64 + std::countr_zero(product.high) >= shift);
    const bool away = detail::rounds_away(is_negative, is_exact, rest_against_half(product, shift), rounding);
    return detail::saturated(is_negative, away && kept.low + 1 != 0 ? kept.low + 1 : kept.low);
}

/// a * b against c * d, exactly.
constexpr std::strong_ordering compare_products(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
    return multiply(a, b) <=> multiply(c, d);
}

}  // namespace portable

#ifdef __SIZEOF_INT128__

namespace native {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

constexpr std::int64_t saturated(Int128 value) {
    const auto kept = static_cast<std::int64_t>(value);
    if (kept == value) return kept;
    return value < 0 ? std::numeric_limits<std::int64_t>::min() : std::numeric_limits<std::int64_t>::max();
}

/// n / d rounded, d above 0.
template <class Int>
constexpr Int divide(Int n, Int d, Rounding rounding) {
    Int quotient = n / d;
    Int remainder = n % d;
    if (remainder < 0) {
        remainder += d;
        --quotient;
    }
    return rounding == Rounding::NearestHalfUp && remainder >= d - remainder ? quotient + 1 : quotient;
}

/// a * b / c. See oblong::mul_div.
constexpr std::int64_t mul_div(std::int64_t a, std::int64_t b, std::int64_t c, Rounding rounding) {
    const Int128 product = Int128{a} * b;
    if (c == 0) return detail::divided_by_zero(product < 0, product == 0);
    const Int128 numerator = c < 0 ? -product : product;
    const Int128 divisor = c < 0 ? -Int128{c} : Int128{c};
    constexpr Int128 kNarrow = std::numeric_limits<std::int64_t>::max();
    const bool is_narrow = numerator <= kNarrow && numerator >= -kNarrow && divisor <= kNarrow;
    if (is_narrow) return divide(static_cast<std::int64_t>(numerator), static_cast<std::int64_t>(divisor), rounding);
    return saturated(divide(numerator, divisor, rounding));
}

/// a * b / 2^shift. See oblong::mul_shift.
constexpr std::int64_t mul_shift(std::int64_t a, std::int64_t b, int shift, Rounding rounding) {
    return saturated(rounded_shift(Int128{a} * b, shift, rounding));
}

/// a * b against c * d, exactly.
constexpr std::strong_ordering compare_products(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
    return Uint128{a} * b <=> Uint128{c} * d;
}

}  // namespace native

namespace chosen_wide = native;
#else
namespace chosen_wide = portable;
#endif

/// a * b / c of the exact 128-bit product, rounded once. Saturates where the quotient does not fit; division by zero
/// gives the lowest or highest value, by the product's sign, and 0 / 0 gives 0.
constexpr std::int64_t mul_div(std::int64_t a, std::int64_t b, std::int64_t c,
                               Rounding rounding = Rounding::NearestHalfUp) {
    return chosen_wide::mul_div(a, b, c, rounding);
}

/// a * b / 2^shift of the exact 128-bit product, rounded once; saturates. `shift` 0 to 126.
constexpr std::int64_t mul_shift(std::int64_t a, std::int64_t b, int shift,
                                 Rounding rounding = Rounding::NearestHalfUp) {
    return chosen_wide::mul_shift(a, b, shift, rounding);
}

/// a * b against c * d, exactly: a fraction a / d against c / b without dividing.
constexpr std::strong_ordering compare_products(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
    return chosen_wide::compare_products(a, b, c, d);
}

}  // namespace oblong
