#pragma once

#include <cstdint>

/// Where the engine's arithmetic could run out of bits: the largest intermediate values, by name. In the build that
/// OBLONG_RECORD_RANGES makes (tests/ranges) every value that one of them takes is recorded, to show how many bits are
/// left; in every other build note_range is nothing.
namespace oblong {

enum class Quantity {
    ViewPosition,
    RotatedDot,
    DistanceToPlane,
    EyeTexel,
    EyeTexelSum,
    ClipDistance,
    ClipWhole,
    CullMix,
    CullDistance,
    ProjectionNumerator,
    ScreenPosition,
    EdgeNumerator,
    EdgeRest,
    NormalSlope,
    TexelAxisSlope,
    InverseZSlope,
    TexelSlope,
    InverseZ,
    TexelOverZ,
    DepthShifted,
    DepthProduct,
    ThresholdProduct,
    MipProduct,
    Count
};

}  // namespace oblong

#if defined(OBLONG_RECORD_RANGES)

#include <array>
#include <limits>
#include <type_traits>

namespace oblong {

struct SeenRange {
    std::int64_t least = std::numeric_limits<std::int64_t>::max(), greatest = std::numeric_limits<std::int64_t>::min();
};

/// The one variable of the engine that is not handed in: a recorder through every signature would make the engine that
/// is measured another one than the engine that draws. It exists in the recording build alone.
inline std::array<SeenRange, static_cast<std::size_t>(Quantity::Count)> recorded_ranges;

template <Quantity Name>
constexpr void note_range(std::int64_t value) {
    if (std::is_constant_evaluated()) return;
    SeenRange& seen = recorded_ranges[static_cast<std::size_t>(Name)];
    if (value < seen.least) seen.least = value;
    if (value > seen.greatest) seen.greatest = value;
}

}  // namespace oblong

#else

namespace oblong {

template <Quantity Name>
constexpr void note_range(std::int64_t) {}

}  // namespace oblong

#endif
