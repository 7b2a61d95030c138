#pragma once

#include "engine/fixed/wide.h"
#include "engine/math/soft_float.h"

namespace oblong {

/// An exact sum of products, below 2^127: determinants of integers are rounded only once.
class WideSum {
  public:
    constexpr void add_product(std::int64_t a, std::int64_t b) {
        const portable::Uint128 size = portable::multiply(detail::magnitude(a), detail::magnitude(b));
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
        const portable::Uint128 size = is_negative ? negated(sum_) : sum_;
        const int bits = 128 - (size.high != 0 ? std::countl_zero(size.high) : 64 + std::countl_zero(size.low));
        const int drop = bits > 62 ? bits - 62 : 0;
        const auto leading = static_cast<std::int64_t>(portable::shift_right(size, drop).low);
        return SoftFloat::from(is_negative ? -leading : leading, exponent + drop);
    }

  private:
    static constexpr portable::Uint128 negated(portable::Uint128 value) {
        return portable::add({~value.high, ~value.low}, {0, 1});
    }

    portable::Uint128 sum_;  ///< two's complement
};

}  // namespace oblong
