#pragma once

#include <array>

#include "engine/fixed/angle.h"
#include "engine/fixed/fixed.h"

namespace oblong {

/// Methods for a sine: those of games of the time, and the engine's own (fixed/trig.h). The error is the worst over all
/// binary angles.
enum class SineMethod {
    Nearest256,       ///< the nearest of 256 entries to the turn: 2^-6.3
    Lerp256,          ///< a straight line between two of 256: 2^-13.6
    Cordic16,         ///< 16 rotations by arctan 2^-i, shifts and sums only: 2^-15
    Quarter1024Lerp,  ///< a line between two of 1,024 to the quarter turn: 2^-21.6; odd, bit for bit
    Cordic30,         ///< 30 rotations: 2^-26
    NearestStep       ///< the nearest step of 2^-30
};

/// From the coarsest.
inline constexpr std::array kSineMethods = {SineMethod::Nearest256,      SineMethod::Lerp256,  SineMethod::Cordic16,
                                            SineMethod::Quarter1024Lerp, SineMethod::Cordic30, SineMethod::NearestStep};

Unit sine(Angle angle, SineMethod method);
/// Bit for bit sine(angle + kQuarterTurn, method).
Unit cosine(Angle angle, SineMethod method);

}  // namespace oblong
