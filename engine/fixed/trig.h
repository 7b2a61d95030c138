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

/// Sine of a binary angle, rounded to the nearest 2^-30. Bit for bit: sin(-a) = -sin(a), sin(a + half turn) = -sin(a).
Unit sine(Angle angle);
/// Cosine of a binary angle; bit for bit sine(angle + kQuarterTurn).
Unit cosine(Angle angle);

struct SineCosine60 {
    Sine60 sine, cosine;
};

/// Sine and cosine of a binary angle, each within 2^-58.
SineCosine60 sine_cosine(Angle angle);
/// The same for half the angle (0 to less than half a turn), which may be between two binary angles; for quaternions.
SineCosine60 half_angle_sine_cosine(Angle angle);
/// The same for 0 to 180 degrees, each within 2^-57; for half a field of view.
SineCosine60 sine_cosine(Degrees angle);

/// The nearest binary angle modulo a turn; ties go to the larger. Any sign.
Angle degrees_to_angle(Degrees degrees);

/// atan2: the direction of (x, y) as the nearest binary angle counter-clockwise from +x; 0 for (0, 0).
Angle arctangent2(std::int64_t y, std::int64_t x);
template <class Int, int Frac>
Angle arctangent2(Fixed<Int, Frac> y, Fixed<Int, Frac> x) {
    return arctangent2(std::int64_t{y.raw}, std::int64_t{x.raw});
}

}  // namespace oblong
