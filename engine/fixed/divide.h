#pragma once

#include <cstdint>

#include "engine/fixed/native/native.h"

// Divisions of numbers that are mostly shorter than 64 bits.

namespace oblong {

struct Division {
    std::uint64_t quotient = 0, remainder = 0;
};

/// n / d, d > 0.
constexpr Division divide(std::uint64_t n, std::uint64_t d) {
    if (const auto short_d = static_cast<std::uint32_t>(d); native::kHasShortRegisters && short_d == d) {
        const auto high = static_cast<std::uint32_t>(n >> 32);
        const ShortDivision upper =
            high < short_d ? ShortDivision{0, high} : ShortDivision{high / short_d, high % short_d};
        const ShortDivision lower =
            native::divide_to_32(std::uint64_t{upper.remainder} << 32 | static_cast<std::uint32_t>(n), short_d);
        return {std::uint64_t{upper.quotient} << 32 | lower.quotient, lower.remainder};
    }
    return {n / d, n % d};
}

struct FlooredDivision {
    std::int64_t quotient = 0, remainder = 0;
};

/// n / d rounded toward minus infinity, d > 0.
constexpr FlooredDivision floored_division(std::int64_t n, std::int64_t d) {
    if constexpr (native::kHasShortRegisters) {  // for n < 0: floor(n / d) = ~floor(~n / d)
        const std::int64_t sign = n >> 63;
        const Division size = divide(static_cast<std::uint64_t>(n ^ sign), static_cast<std::uint64_t>(d));
        const auto rest = static_cast<std::int64_t>(size.remainder);
        return {static_cast<std::int64_t>(size.quotient) ^ sign, sign == 0 ? rest : d - 1 - rest};
    }
    const std::int64_t quotient = n / d, rest = n % d, is_below = rest < 0;
    return {quotient - is_below, rest + (d & -is_below)};
}

}  // namespace oblong
