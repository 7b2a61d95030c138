#pragma once

#include <cstdint>

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/fixed.h"
#include "engine/fixed/wide.h"

namespace oblong {

/// The floor of the square root: r r <= value < (r + 1)(r + 1), for every value.
std::uint32_t integer_root(std::uint64_t value);
/// The same for a 128-bit number.
std::uint64_t integer_root(Uint128 value);

/// 1 / sqrt(value) without a division: mantissa * 2^-(30 + shift), the mantissa from 2^30 - 8 to 2^31, the shift 1 to
/// 32. Relative error below 2^-27.
struct ReciprocalRoot {
    std::uint32_t mantissa;
    int shift;
};
/// `value` is not 0.
ReciprocalRoot reciprocal_root(std::uint64_t value);

}  // namespace oblong
