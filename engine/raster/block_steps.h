#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "engine/base/table.h"
#include "engine/fixed/fixed.h"

namespace oblong {

/// A texture coordinate pair, texels, 16.16.
struct TexelPosition {
    std::uint32_t u_16 = 0, v_16 = 0;
};

/// Change of a TexelPosition per pixel, 16.16.
struct TexelStep {
    std::int32_t u_16 = 0, v_16 = 0;
};

/// Whether both are below 32,768 texels, so that a difference fits 32 bits.
inline bool are_short(TexelPosition from, TexelPosition to) {
    return (from.u_16 | from.v_16 | to.u_16 | to.v_16) >> 31 == 0;
}

/// whole / steps, rounded down, with one division instruction.
inline std::int32_t floored(std::int32_t whole, std::int32_t steps) {
    return whole / steps + (whole % steps >> 31);
}

/// The steps over 2^log2 pixels, rounded down.
inline TexelStep steps_by_shift(TexelPosition from, TexelPosition to, int log2) {
    if (native::kHasShortRegisters && are_short(from, to))
        return {static_cast<std::int32_t>(to.u_16 - from.u_16) >> log2,
                static_cast<std::int32_t>(to.v_16 - from.v_16) >> log2};
    return {static_cast<std::int32_t>(floor_shift(std::int64_t{to.u_16} - from.u_16, log2)),
            static_cast<std::int32_t>(floor_shift(std::int64_t{to.v_16} - from.v_16, log2))};
}

/// The step of u or v over `steps` pixels, 1 or more, rounded down. For steps = 1 it is clamped to 32,767 texels, the
/// most that its format holds.
inline std::int32_t step_by_division(std::int64_t whole, std::int32_t steps) {
    constexpr std::int64_t kSteepest = std::numeric_limits<std::int32_t>::max();
    if (steps == 1) return static_cast<std::int32_t>(std::clamp(whole, -kSteepest, kSteepest));
    return static_cast<std::int32_t>(whole / steps - (whole % steps < 0));
}

/// For 1 to 511 steps n: m = 2^36 / n, rounded up by less than 1. If |whole| <= 2^26, whole m differs from 2^36 whole /
/// n by less than 2^26, and floor((whole m + 2^26) / 2^36) = floor(whole / n): a quotient that is not an integer is at
/// least 1/511, more than 2^27 / 2^36, below the next integer.
inline constexpr std::int32_t kStepReciprocals = 512;
inline constexpr std::array<std::int64_t, kStepReciprocals> kStepReciprocal_36 = [] {
    std::array<std::int64_t, kStepReciprocals> reciprocals{};
    for (std::int64_t n = 1; n < kStepReciprocals; ++n) item(reciprocals, n) = ((std::int64_t{1} << 36) + n - 1) / n;
    return reciprocals;
}();

/// The steps over 1 to 4,095 pixels, equal to step_by_division(), by the table where that is exact.
inline TexelStep steps_by_division(TexelPosition from, TexelPosition to, std::int32_t steps) {
    if (native::kHasShortRegisters && are_short(from, to))
        return {floored(static_cast<std::int32_t>(to.u_16 - from.u_16), steps),
                floored(static_cast<std::int32_t>(to.v_16 - from.v_16), steps)};
    constexpr std::int64_t kMost = std::int64_t{1} << 26;
    const std::int64_t u = std::int64_t{to.u_16} - from.u_16, v = std::int64_t{to.v_16} - from.v_16;
    const auto beyond = static_cast<std::uint64_t>(u + kMost) | static_cast<std::uint64_t>(v + kMost);
    if (beyond >= 2 * kMost || static_cast<std::uint32_t>(steps) >= kStepReciprocals)
        return {step_by_division(u, steps), step_by_division(v, steps)};
    const std::int64_t reciprocal_36 = item(kStepReciprocal_36, steps);
    return {static_cast<std::int32_t>(floor_shift(u * reciprocal_36 + kMost, 36)),
            static_cast<std::int32_t>(floor_shift(v * reciprocal_36 + kMost, 36))};
}

}  // namespace oblong
