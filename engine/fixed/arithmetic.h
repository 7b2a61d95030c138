#pragma once

// Arithmetic between formats: the exact result is rounded once, by the named rule. Functions that say "saturates" clamp
// it to the format's range, and are defined for every input.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <numeric>

#include "engine/fixed/fixed.h"
#include "engine/fixed/wide.h"

namespace oblong {

/// The number with this raw value; saturates.
template <class To>
constexpr To saturated_to(std::int64_t raw) {
    using Raw = typename To::Raw;
    constexpr std::int64_t kLowest = std::numeric_limits<Raw>::min(), kHighest = std::numeric_limits<Raw>::max();
    return To::from_raw(static_cast<Raw>(std::clamp(raw, kLowest, kHighest)));
}

/// a + b; saturates.
constexpr std::int64_t saturating_sum(std::int64_t a, std::int64_t b) {
    if (b > 0 && a > std::numeric_limits<std::int64_t>::max() - b) return std::numeric_limits<std::int64_t>::max();
    if (b < 0 && a < std::numeric_limits<std::int64_t>::min() - b) return std::numeric_limits<std::int64_t>::min();
    return a + b;
}

template <int Frac>
constexpr Fixed<std::int64_t, Frac> saturating_sum(Fixed<std::int64_t, Frac> a, Fixed<std::int64_t, Frac> b) {
    return Fixed<std::int64_t, Frac>::from_raw(saturating_sum(a.raw, b.raw));
}

/// |value| in steps, also of the lowest number.
template <class Int, int Frac>
constexpr std::uint64_t magnitude(Fixed<Int, Frac> value) {
    return detail::magnitude(value.raw);
}

/// `value` in another format; saturates.
template <class To, class Int, int Frac>
constexpr To saturating_convert(Fixed<Int, Frac> value, Rounding rounding = Rounding::NearestHalfUp) {
    constexpr int kMoreBits = To::kFractionBits - Frac;
    static_assert(kMoreBits <= 62);
    if constexpr (kMoreBits >= 0) return saturated_to<To>(mul_shift(value.raw, std::int64_t{1} << kMoreBits, 0));
    return saturated_to<To>(mul_shift(value.raw, 1, std::max(-kMoreBits, 0), rounding));
}

/// The product in the factors' format; saturates.
template <class Int, int Frac>
constexpr Fixed<Int, Frac> multiply(Fixed<Int, Frac> a, Fixed<Int, Frac> b,
                                    Rounding rounding = Rounding::NearestHalfUp) {
    if constexpr (sizeof(Int) <= 2)
        return saturated_to<Fixed<Int, Frac>>(rounded_shift(std::int32_t{a.raw} * b.raw, Frac, rounding));
    else if constexpr (sizeof(Int) <= 4)
        return saturated_to<Fixed<Int, Frac>>(rounded_shift(std::int64_t{a.raw} * b.raw, Frac, rounding));
    else
        return saturated_to<Fixed<Int, Frac>>(mul_shift(a.raw, b.raw, Frac, rounding));
}

/// a / b; saturates. Division by zero gives the lowest or highest value, by the sign of `a`; 0 / 0 gives 0.
template <class To, class A, int FracA, class B, int FracB>
constexpr To divide(Fixed<A, FracA> a, Fixed<B, FracB> b, Rounding rounding = Rounding::NearestHalfUp) {
    constexpr int kShift = To::kFractionBits + FracB - FracA;
    static_assert(kShift >= 0 && kShift <= 62, "the quotient's scale fits 64 bits");
    return saturated_to<To>(mul_div(a.raw, std::int64_t{1} << kShift, b.raw, rounding));
}

/// a b in the format To, from 128 bits, rounded once; saturates.
template <class To, class A, int FracA, class B, int FracB>
constexpr To product(Fixed<A, FracA> a, Fixed<B, FracB> b, Rounding rounding = Rounding::NearestHalfUp) {
    return saturated_to<To>(mul_shift(a.raw, b.raw, FracA + FracB - To::kFractionBits, rounding));
}

/// a b in the format To, rounded once; it must fit 64 bits, or wraps.
template <class To, int FracA, int FracB>
constexpr To wrapping_product(Fixed<std::int32_t, FracA> a, Fixed<std::int64_t, FracB> b) {
    return To::from_raw(wrapping_mul_shift(a.raw, b.raw, FracA + FracB - To::kFractionBits));
}

/// a b / c, from 128 bits, rounded once; saturates as divide() does. `c` has room for the bits that To drops.
template <class To, class A, int FracA, class B, int FracB, class C, int FracC>
constexpr To product_over(Fixed<A, FracA> a, Fixed<B, FracB> b, Fixed<C, FracC> c) {
    constexpr int kDropped = FracA + FracB - FracC - To::kFractionBits;
    return saturated_to<To>(mul_div(a.raw, b.raw, std::int64_t{c.raw} * (std::int64_t{1} << kDropped)));
}

/// a / b rounded to nearest, with one 64-bit division. b > 0; `a` and `b` have room for the bits that To drops.
template <class To, int FracA, int FracB>
constexpr To bounded_quotient(Fixed<std::int64_t, FracA> a, Fixed<std::int64_t, FracB> b) {
    constexpr int kDropped = FracA - FracB - To::kFractionBits;
    const std::int64_t numerator = a.raw + b.raw * (std::int64_t{1} << (kDropped - 1));
    return To::from_raw(floored_division(floor_shift(numerator, kDropped), b.raw).quotient);
}

/// a / b rounded toward zero, with one division. It must fit.
template <class To, class A, int FracA, class B, int FracB>
constexpr To truncated_quotient(Fixed<A, FracA> a, Fixed<B, FracB> b) {
    static_assert(To::kFractionBits == FracA - FracB);
    return To::from_raw(static_cast<typename To::Raw>(a.raw / b.raw));
}

/// 1 / value; saturates, 1 / 0 gives the highest number. The exact counterpart of reciprocal.h.
template <class To, class Int, int Frac>
constexpr To reciprocal(Fixed<Int, Frac> value, Rounding rounding = Rounding::NearestHalfUp) {
    static_assert(To::kFractionBits <= 62 && Frac <= 62);
    if constexpr (To::kFractionBits + Frac <= 62) {
        if (value.raw > 0) {
            const auto divisor = static_cast<std::uint64_t>(value.raw);
            const auto [quotient, rest] = divide(std::uint64_t{1} << (To::kFractionBits + Frac), divisor);
            const bool rounds_up = rounding == Rounding::NearestHalfUp && rest >= divisor - rest;
            return saturated_to<To>(static_cast<std::int64_t>(quotient + rounds_up));
        }
    }
    const std::int64_t raw =
        mul_div(std::int64_t{1} << To::kFractionBits, std::int64_t{1} << Frac, value.raw, rounding);
    return saturated_to<To>(raw);
}

/// from + (to - from) part / whole, rounded once; saturates. `part` and `whole` have the same format.
template <class Int, int Frac, class Part>
constexpr Fixed<Int, Frac> between(Fixed<Int, Frac> from, Fixed<Int, Frac> to, Part part, Part whole) {
    const std::int64_t way = mul_div(std::int64_t{to.raw} - from.raw, part.raw, whole.raw);
    return saturated_to<Fixed<Int, Frac>>(saturating_sum(from.raw, way));
}

/// floor(log2(value)), the position of the highest set bit. `value` is not 0.
constexpr int log2_floor(std::uint64_t value) {
    return 63 - std::countl_zero(value);
}
/// The same for a number's steps; value > 0.
template <class Int, int Frac>
constexpr int log2_floor(Fixed<Int, Frac> value) {
    return log2_floor(static_cast<std::uint64_t>(value.raw));
}

/// An exact small fraction, such as the aspect ratio of a display (4:3) or a pixel (5:6). The denominator is positive.
struct Ratio {
    std::int64_t numerator = 0, denominator = 1;

    constexpr Ratio reduced() const {
        const std::int64_t divisor = std::gcd(numerator, denominator);
        return divisor == 0 ? *this : Ratio{numerator / divisor, denominator / divisor};
    }
    constexpr Ratio operator*(Ratio other) const {
        return Ratio{numerator * other.numerator, denominator * other.denominator}.reduced();
    }
    constexpr Ratio inverse() const { return Ratio{denominator, numerator}; }
    constexpr bool operator==(Ratio other) const {
        return numerator * other.denominator == other.numerator * denominator;
    }
};

}  // namespace oblong
