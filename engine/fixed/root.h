#pragma once

#include <cstdint>

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/fixed.h"
#include "engine/fixed/wide.h"

namespace oblong {

/// The floor of the square root: r r <= value < (r + 1)(r + 1), for every value.
std::uint32_t integer_root(std::uint64_t value);
/// The same for a 128-bit number.
std::uint64_t integer_root(portable::Uint128 value);

/// 1 / sqrt(value) without a division: mantissa * 2^-(30 + shift), the mantissa from 2^30 - 8 to 2^31, the shift 1 to
/// 32. Relative error below 2^-27.
struct ReciprocalRoot {
    std::uint32_t mantissa;
    int shift;
};
/// `value` is not 0.
ReciprocalRoot reciprocal_root(std::uint64_t value);

/// The square root of `value` in the format To, exact before it is rounded. A negative value has the root 0.
template <class To, class Int, int Frac>
To square_root(Fixed<Int, Frac> value, Rounding rounding = Rounding::Floor) {
    // One bit more than To has, for the rounding: a root is never a tie, for its square would end in a quarter.
    constexpr int kShift = 2 * (To::kFractionBits + 1) - Frac;
    static_assert(kShift >= 0 && kShift <= 63, "the radicand fits 128 bits");
    if (value.raw <= 0) return To{};
    const std::uint64_t root =
        integer_root(portable::multiply(static_cast<std::uint64_t>(value.raw), std::uint64_t{1} << kShift));
    const std::uint64_t rounded = rounding == Rounding::Floor ? root >> 1 : (root >> 1) + (root & 1);
    return saturated_to<To>(detail::saturated(false, rounded));
}

}  // namespace oblong
