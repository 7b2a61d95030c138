#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include "engine/fixed/wide.h"

namespace oblong {

/// mantissa * 2^exponent, for numbers without a common scale: in an elimination, far off the screen. Except for 0, the
/// mantissa has 62 bits. Products and quotients have a relative error of at most 2^-60, differences an error of at most
/// 2^-60 of the larger operand.
struct SoftFloat {
    std::int64_t mantissa = 0;
    int exponent = 0;

    /// Normalises to a mantissa of 62 bits.
    static constexpr SoftFloat from(std::int64_t mantissa, int exponent) {
        if (mantissa == 0) return {};
        const int shift = std::countl_zero(detail::magnitude(mantissa)) - 2;
        if (shift < 0) return {floor_shift(mantissa, -shift), exponent - shift};
        return {mantissa * (std::int64_t{1} << shift), exponent - shift};
    }

    template <class Int, int Frac>
    static constexpr SoftFloat from(Fixed<Int, Frac> value) {
        return from(value.raw, -Frac);
    }

    constexpr bool is_zero() const { return mantissa == 0; }
    /// |number| < 2^magnitude() <= 2 |number|; not for 0.
    constexpr int magnitude() const { return exponent + 62; }
};

constexpr SoftFloat operator*(const SoftFloat& a, const SoftFloat& b) {
    return SoftFloat::from(mul_shift(a.mantissa, b.mantissa, 62), a.exponent + b.exponent + 62);
}

/// `b` is not 0.
constexpr SoftFloat operator/(const SoftFloat& a, const SoftFloat& b) {
    return SoftFloat::from(mul_div(a.mantissa, std::int64_t{1} << 61, b.mantissa), a.exponent - b.exponent - 61);
}

constexpr SoftFloat operator-(const SoftFloat& a) {
    return {-a.mantissa, a.exponent};
}

constexpr SoftFloat operator-(const SoftFloat& a, const SoftFloat& b) {
    if (b.is_zero()) return a;
    if (a.is_zero()) return {-b.mantissa, b.exponent};
    const int top = a.exponent > b.exponent ? a.exponent : b.exponent;
    const auto aligned = [top](const SoftFloat& value) {
        const int drop = top - value.exponent;
        return drop > 62 ? 0 : rounded_shift(value.mantissa, drop, Rounding::NearestHalfUp);
    };
    return SoftFloat::from(aligned(a) - aligned(b), top);
}

constexpr SoftFloat operator+(const SoftFloat& a, const SoftFloat& b) {
    return a - -b;
}

/// The number with `fraction_bits`, rounded to nearest; none if it has more than 62 bits.
constexpr std::optional<std::int64_t> fixed_of(const SoftFloat& value, int fraction_bits) {
    const int shift = value.exponent + fraction_bits;
    if (value.is_zero() || shift < -62) return 0;
    if (shift > 0) return std::nullopt;
    return rounded_shift(value.mantissa, -shift, Rounding::NearestHalfUp);
}

/// The same in a format.
template <class To>
constexpr std::optional<To> fixed_of(const SoftFloat& value) {
    const std::optional<std::int64_t> raw = fixed_of(value, To::kFractionBits);
    if (!raw) return std::nullopt;
    return To::from_raw(*raw);
}

/// An exact sum of products, below 2^127: determinants of integers are rounded only once.
class WideSum {
  public:
    constexpr void add_product(std::int64_t a, std::int64_t b) {
        const Uint128 size = native::product_to_128(detail::magnitude(a), detail::magnitude(b));
        sum_ = portable::add(sum_, (a < 0) != (b < 0) ? negated(size) : size);
    }

    /// For Fixed numbers; the sum has the fraction bits of both.
    template <class A, int FracA, class B, int FracB>
    constexpr void add_product(Fixed<A, FracA> a, Fixed<B, FracB> b) {
        add_product(a.raw, b.raw);
    }

    /// The sum times 2^exponent, truncated to the leading 62 bits.
    constexpr SoftFloat scaled(int exponent) const {
        const bool is_negative = sum_.high >> 63 != 0;
        const Uint128 size = is_negative ? negated(sum_) : sum_;
        const int bits = 128 - (size.high != 0 ? std::countl_zero(size.high) : 64 + std::countl_zero(size.low));
        const int drop = bits > 62 ? bits - 62 : 0;
        const auto leading = static_cast<std::int64_t>(portable::shift_right(size, drop).low);
        return SoftFloat::from(is_negative ? -leading : leading, exponent + drop);
    }

  private:
    static constexpr Uint128 negated(Uint128 value) { return portable::add({~value.high, ~value.low}, {0, 1}); }

    Uint128 sum_;  ///< two's complement
};

}  // namespace oblong
