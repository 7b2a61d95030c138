#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "engine/level/level.h"

namespace oblong {

/// The 32 bits of a float in a level file. It is decoded with integers, so that every machine gets the same numbers.
struct FloatBits {
    std::uint32_t bits = 0;
};
using FloatBits3 = std::array<FloatBits, 3>;

/// value * 2^fraction_bits rounded to nearest, ties up; none unless |value| < limit (also for NaN and infinity). limit
/// * 2^fraction_bits must be at most 2^62.
std::optional<std::int64_t> to_fixed(FloatBits value, int fraction_bits, std::int32_t limit);

/// The remainder of `value` after to_fixed(), in units of 2^-(fraction_bits + 30), rounded to nearest: from -2^29 to
/// 2^29. to_fixed() must have accepted the value.
std::int32_t rest_of_fixed(FloatBits value, int fraction_bits);

/// Floor and ceiling; none unless |value| <= 2^20.
std::optional<std::int32_t> floor_to_int(FloatBits value);
std::optional<std::int32_t> ceil_to_int(FloatBits value);

/// For messages: "1.500000", "nan", "inf", "2^127 or more".
std::string describe(FloatBits value);

/// A face's range along one texture axis, in texels: both multiples of 16.
struct TexelRange {
    std::int32_t min = 0, extent = 0;
};

/// The range of axis . p + offset over a polygon, rounded outward to multiples of 16, the size of a lightmap's cell.
/// The sum is rounded to double after each term and then to float, as in light compilers and engines (QuakeSpasm,
/// gl_model.c, CalcSurfaceExtents; id's light, ltface.c, CalcFaceExtents, with 80 bits before): lightmaps have extent /
/// 16 + 1 samples a side, so all must round alike. Axes of real levels have components like 6e-17, which exceed a
/// border of 16 texels in doubles, but not in floats. The caller has checked that all floats are finite and that the
/// result is far below 32 bits.
TexelRange texel_range(std::span<const FloatBits3> polygon, const std::array<FloatBits, 4>& axis);

}  // namespace oblong
