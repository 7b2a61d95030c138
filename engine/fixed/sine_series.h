#pragma once

#include <cstdint>

#include "engine/fixed/wide.h"

// Taylor series in integers, the source of all sine tables. Sines have 62 fraction bits, and angles are in half binary
// degrees, so that the middle between two binary angles is an integer.

namespace oblong::detail {

inline constexpr std::int64_t kOne62 = std::int64_t{1} << 62;
inline constexpr int kQuarterHalves = 1 << 15;

// pi / 65536 (half a binary degree in radians) times 2^76; pi / 180 times 2^68; both rounded to nearest.
inline constexpr std::int64_t kRadiansPerHalf76 = 3622009729038561421;
inline constexpr std::int64_t kRadiansPerDegree68 = 5151302725743731799;

/// first - first x^2 / (n (n+1)) + first x^4 / (n (n+1) (n+2) (n+3)) - ..., until the terms vanish.
constexpr std::int64_t alternating_series_62(std::int64_t first, std::int64_t x_squared, std::int64_t n) {
    std::int64_t sum = first;
    for (std::int64_t term = first; term != 0; n += 2) {
        term = -mul_shift(term, x_squared, 62) / (n * (n + 1));
        sum += term;
    }
    return sum;
}

/// 0 <= radians <= pi / 4; sine and cosine are within 2^-58.
constexpr std::int64_t sine_series_62(std::int64_t radians_62) {
    return alternating_series_62(radians_62, mul_shift(radians_62, radians_62, 62), 2);
}

constexpr std::int64_t cosine_series_62(std::int64_t radians_62) {
    return alternating_series_62(kOne62, mul_shift(radians_62, radians_62, 62), 1);
}

/// 0 <= halves <= kQuarterHalves.
constexpr std::int64_t radians_of_halves_62(int halves) {
    return mul_shift(halves, kRadiansPerHalf76, 14);
}

/// 0 <= halves <= kQuarterHalves.
constexpr std::int64_t quarter_sine_series_62(int halves) {
    if (halves <= kQuarterHalves / 2) return sine_series_62(radians_of_halves_62(halves));
    return cosine_series_62(radians_of_halves_62(kQuarterHalves - halves));
}

}  // namespace oblong::detail
