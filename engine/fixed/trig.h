#pragma once

#include "engine/fixed/angle.h"
#include "engine/fixed/fixed.h"

namespace oblong {

/// Sine of a binary angle, the nearest step of 2^-30. Bit for bit: sin(-a) = -sin(a), sin(a + half) = -sin(a).
Unit sine(Angle angle);
/// Cosine of a binary angle; bit for bit sine(angle + kQuarterTurn).
Unit cosine(Angle angle);

struct SineCosine60 {
    Sine60 sine, cosine;
};

/// Both of a binary angle, each within 2^-58.
SineCosine60 sine_cosine(Angle angle);
/// Both of half the angle, which may lie between two binary angles (0 to less than half a turn): for quaternions.
SineCosine60 half_angle_sine_cosine(Angle angle);
/// Both of a decimal angle from 0 to 180 degrees, each within 2^-57: for half a field of view.
SineCosine60 sine_cosine(Degrees angle);

/// The nearest binary angle (a tie: the larger). Any sign; modulo a turn.
Angle degrees_to_angle(Degrees degrees);

/// The direction of (x, y), of any length, as the nearest binary angle counter-clockwise from +x (atan2). (0, 0) gives
/// 0.
Angle arctangent2(std::int64_t y, std::int64_t x);
template <class Int, int Frac>
Angle arctangent2(Fixed<Int, Frac> y, Fixed<Int, Frac> x) {
    return arctangent2(std::int64_t{y.raw}, std::int64_t{x.raw});
}

}  // namespace oblong
