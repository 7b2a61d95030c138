#pragma once

#include <bit>
#include <compare>
#include <cstdint>
#include <limits>

#include "engine/fixed/divide.h"
#include "engine/fixed/fixed.h"
#include "engine/fixed/native/native.h"

// 64-bit arithmetic with intermediate results of 128 bits: exact, rounded once by a named rule, and saturating with the
// right sign. `portable` needs no 128-bit type and is always compiled; if the compiler has one, the functions below use
// it, with the same results for every input.

namespace oblong {

namespace detail {

/// |value|, also for the lowest value.
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

/// Whether a truncated magnitude has to be increased by 1; `against_half` compares the dropped fraction with 1/2.
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

/// a + b modulo 2^128.
constexpr Uint128 add(Uint128 a, Uint128 b) {
    const std::uint64_t low = a.low + b.low;
    return {a.high + b.high + (low < a.low ? 1 : 0), low};
}

/// A base-2^32 digit of the quotient of (n, next) by d, whose highest bit is set; n < d. `n` becomes the remainder. The
/// estimate from the leading digits is at most 2 too large (Knuth, The Art of Computer Programming 4.3.1 D).
constexpr std::uint32_t next_digit(std::uint64_t& n, std::uint32_t next, std::uint64_t d) {
    const auto top = static_cast<std::uint32_t>(d >> 32), rest = static_cast<std::uint32_t>(d);
    std::uint32_t digit = ~std::uint32_t{0};
    std::uint64_t left = n - std::uint64_t{digit} * top;
    if (n >> 32 < top) {
        const ShortDivision guess = native::divide_to_32(n, top);
        digit = guess.quotient;
        left = guess.remainder;
    }
    for (; left >> 32 == 0 && std::uint64_t{digit} * rest > (left << 32 | next); left += top) --digit;
    n = (n << 32 | next) - digit * d;
    return digit;
}

/// n / d; n.high < d, so that the quotient fits.
constexpr Division divide(Uint128 n, std::uint64_t d) {
    if (n.high == 0) return oblong::divide(n.low, d);
    const int shift = std::countl_zero(d);
    std::uint64_t left = shift == 0 ? n.high : n.high << shift | n.low >> (64 - shift);
    const std::uint64_t low = n.low << shift, divisor = d << shift;
    const std::uint64_t first = next_digit(left, static_cast<std::uint32_t>(low >> 32), divisor);
    const std::uint64_t second = next_digit(left, static_cast<std::uint32_t>(low), divisor);
    return {first << 32 | second, left >> shift};
}

/// a * b / c. See oblong::mul_div.
constexpr std::int64_t mul_div(std::int64_t a, std::int64_t b, std::int64_t c, Rounding rounding) {
    const bool is_negative = ((a < 0) != (b < 0)) != (c < 0);
    const Uint128 product = native::product_to_128(detail::magnitude(a), detail::magnitude(b));
    const std::uint64_t divisor = detail::magnitude(c);
    if (divisor == 0) return detail::divided_by_zero(is_negative, product == Uint128{});
    if (product.high >= divisor) return detail::saturated(is_negative, ~std::uint64_t{0});
    const auto [quotient, remainder] = divide(product, divisor);
    const bool away = detail::rounds_away(is_negative, remainder == 0, remainder <=> divisor - remainder, rounding);
    return detail::saturated(is_negative, away && quotient + 1 != 0 ? quotient + 1 : quotient);
}

/// value >> shift, `shift` 0 to 126.
constexpr Uint128 shift_right(Uint128 value, int shift) {
    if (shift == 0) return value;
    if (shift >= 64) return {0, value.high >> (shift - 64)};
    return {value.high >> shift, (value.high << (64 - shift)) | (value.low >> shift)};
}

/// a * b + more, exactly.
constexpr Int96 multiply_add(std::int32_t a, std::int64_t b, std::uint32_t more) {
    const auto low_b = static_cast<std::uint32_t>(b);
    const std::uint64_t low = native::product_to_64(static_cast<std::uint32_t>(a), low_b) + more;
    const std::uint32_t too_much = static_cast<std::uint32_t>(a >> 31) & low_b;  // of an `a` below 0
    const auto carry = static_cast<std::int32_t>(static_cast<std::uint32_t>(low >> 32) - too_much);
    return {native::product_to_64(a, static_cast<std::int32_t>(b >> 32)) + carry, static_cast<std::uint32_t>(low)};
}

/// value / 2^shift, floored, modulo 2^64; `shift` 1 to 32.
[[gnu::always_inline]] constexpr std::int64_t shift_right(Int96 value, int shift) {
    return shift == 32 ? value.high : native::shift_right(value, shift);
}

/// a * b / 2^shift, `shift` 33 to 94, from the product's floored quotient by 2^32.
constexpr std::int64_t short_mul_shift(std::int32_t a, std::int64_t b, int shift, Rounding rounding) {
    return rounded_shift(multiply_add(a, b, 0).high, shift - 32, rounding);
}

/// What is added to round by a floored shift of 1 to 32.
constexpr std::uint32_t half_of(int shift, Rounding rounding) {
    return rounding == Rounding::Floor ? 0 : std::uint32_t{1} << (shift - 1);
}

/// The same for `shift` 1 to 32, which needs the bits below as well; saturates.
constexpr std::int64_t short_mul_shift_by_less(std::int32_t a, std::int64_t b, int shift, Rounding rounding) {
    const Int96 product = multiply_add(a, b, half_of(shift, rounding));
    const std::int64_t high = product.high;
    if (const auto short_high = static_cast<std::int32_t>(high); short_high != high) {
        const std::int64_t sign = floor_shift(high, 63);
        if (floor_shift(high, 31 + shift) != sign) return detail::saturated(high < 0, ~std::uint64_t{0});
    }
    return shift_right(product, shift);
}

/// a * b / 2^shift. See oblong::wrapping_mul_shift.
constexpr std::int64_t wrapping_mul_shift(std::int32_t a, std::int64_t b, int shift) {
    if (const auto short_b = static_cast<std::int32_t>(b); short_b == b)
        return floor_shift(native::product_to_64(a, short_b) + half_of(shift, Rounding::NearestHalfUp), shift);
    return shift_right(multiply_add(a, b, half_of(shift, Rounding::NearestHalfUp)), shift);
}

/// a * b / 2^shift: the product in two's complement, plus half a step, floored.
constexpr std::int64_t long_mul_shift(std::int64_t a, std::int64_t b, int shift, Rounding rounding) {
    const auto bits_a = static_cast<std::uint64_t>(a), bits_b = static_cast<std::uint64_t>(b);
    Uint128 product = native::product_to_128(bits_a, bits_b);
    product.high -= (a < 0 ? bits_b : 0) + (b < 0 ? bits_a : 0);
    if (rounding == Rounding::NearestHalfUp && shift > 0) {
        const std::uint64_t half = std::uint64_t{1} << ((shift - 1) & 63);
        product = add(product, shift > 64 ? Uint128{half, 0} : Uint128{0, half});
    }
    const auto high = static_cast<std::int64_t>(product.high);
    if (shift >= 64) return floor_shift(high, shift - 64);
    const auto kept = static_cast<std::int64_t>(shift_right(product, shift).low);
    const bool fits = floor_shift(high, shift) == floor_shift(kept, 63);
    return fits ? kept : detail::saturated(high < 0, ~std::uint64_t{0});
}

/// a * b / 2^shift. See oblong::mul_shift.
[[gnu::always_inline]] constexpr std::int64_t mul_shift(std::int64_t a, std::int64_t b, int shift, Rounding rounding) {
    const auto short_a = static_cast<std::int32_t>(a);
    if (shift > 32 && shift < 95 && short_a == a) return short_mul_shift(short_a, b, shift, rounding);
    if (shift > 0 && shift <= 32 && short_a == a) return short_mul_shift_by_less(short_a, b, shift, rounding);
    return long_mul_shift(a, b, shift, rounding);
}

/// Compares a * b with c * d exactly.
constexpr std::strong_ordering compare_products(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
    return native::product_to_128(a, b) <=> native::product_to_128(c, d);
}

}  // namespace portable

#ifdef __SIZEOF_INT128__

namespace by_128_bits {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

constexpr std::int64_t saturated(Int128 value) {
    const auto kept = static_cast<std::int64_t>(value);
    if (kept == value) return kept;
    return value < 0 ? std::numeric_limits<std::int64_t>::min() : std::numeric_limits<std::int64_t>::max();
}

/// n / d rounded, d > 0.
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

/// a * b / 2^shift. See oblong::wrapping_mul_shift.
constexpr std::int64_t wrapping_mul_shift(std::int32_t a, std::int64_t b, int shift) {
    return static_cast<std::int64_t>(rounded_shift(Int128{a} * b, shift, Rounding::NearestHalfUp));
}

/// Compares a * b with c * d exactly.
constexpr std::strong_ordering compare_products(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
    return Uint128{a} * b <=> Uint128{c} * d;
}

}  // namespace by_128_bits

namespace chosen_wide = by_128_bits;
#else
namespace chosen_wide = portable;
#endif

/// a * b / c from the exact 128-bit product, rounded once; saturates. Division by zero gives the lowest or highest
/// value, by the product's sign, and 0 / 0 gives 0.
constexpr std::int64_t mul_div(std::int64_t a, std::int64_t b, std::int64_t c,
                               Rounding rounding = Rounding::NearestHalfUp) {
    return chosen_wide::mul_div(a, b, c, rounding);
}

/// a * b / 2^shift from the exact 128-bit product, rounded once; saturates. `shift` 0 to 126.
[[gnu::always_inline]] constexpr std::int64_t mul_shift(std::int64_t a, std::int64_t b, int shift,
                                                        Rounding rounding = Rounding::NearestHalfUp) {
    return chosen_wide::mul_shift(a, b, shift, rounding);
}

/// a * b / 2^shift of the exact product, rounded once to the nearest, modulo 2^64. `shift` 1 to 32.
constexpr std::int64_t wrapping_mul_shift(std::int32_t a, std::int64_t b, int shift) {
    return chosen_wide::wrapping_mul_shift(a, b, shift);
}

/// Compares a * b with c * d exactly: the fraction a / d with c / b without dividing.
constexpr std::strong_ordering compare_products(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
    return chosen_wide::compare_products(a, b, c, d);
}

}  // namespace oblong
