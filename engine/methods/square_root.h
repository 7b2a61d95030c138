#pragma once

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/root.h"

namespace oblong {

/// The square root of `value` in the format To, exact before it is rounded. A negative value has the root 0.
template <class To, class Int, int Frac>
To square_root(Fixed<Int, Frac> value, Rounding rounding = Rounding::Floor) {
    // One bit more than To has, for rounding: a root is never a tie, since its square would then end in a quarter.
    constexpr int kShift = 2 * (To::kFractionBits + 1) - Frac;
    static_assert(kShift >= 0 && kShift <= 63, "the radicand fits 128 bits");
    if (value <= decltype(value){}) return To{};
    const std::uint64_t root =
        integer_root(native::product_to_128(std::uint64_t{value.bits()}, std::uint64_t{1} << kShift));
    const std::uint64_t rounded = rounding == Rounding::Floor ? root >> 1 : (root >> 1) + (root & 1);
    return saturated_to<To>(detail::saturated(false, rounded));
}

}  // namespace oblong
