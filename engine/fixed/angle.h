#pragma once

#include <cstdint>

#include "engine/fixed/fixed.h"

namespace oblong {

/// Degrees, 16.48; in public interfaces only: field of view, angles on a command line.
using Degrees = Fixed<std::int64_t, 48>;

/// An angle in binary degrees, 65,536 to the turn: arithmetic wraps at a turn. Unsigned, so that it can be shifted to
/// index a table.
struct Angle {
    std::uint16_t bam = 0;

    static constexpr Angle from_bam(std::int64_t any) { return Angle{static_cast<std::uint16_t>(any)}; }

    constexpr Angle operator-() const { return from_bam(-std::int64_t{bam}); }
    constexpr Angle operator+(Angle other) const { return from_bam(std::int64_t{bam} + other.bam); }
    constexpr Angle operator-(Angle other) const { return from_bam(std::int64_t{bam} - other.bam); }
    constexpr bool operator==(const Angle&) const = default;
};

inline constexpr Angle kQuarterTurn{0x4000}, kHalfTurn{0x8000};

}  // namespace oblong
