#pragma once

#include "engine/fixed/fixed.h"
#include "engine/fixed/trig.h"

namespace oblong {

/// Methods for a sine: those of games of the time, and the engine's (fixed/trig.h), with the largest error over all
/// binary angles.
enum class SineMethod {
    Nearest256,       ///< nearest of 256 entries a turn: 2^-6.3
    Lerp256,          ///< linear between 256 entries a turn: 2^-13.6
    Cordic16,         ///< 16 rotations by arctan 2^-i, with shifts and additions only: 2^-15
    Quarter1024Lerp,  ///< linear between 1,024 entries a quarter turn: 2^-21.6; an odd function, bit for bit
    Cordic30,         ///< 30 rotations: 2^-26
    NearestStep       ///< the nearest step of 2^-30
};

Unit sine(Angle angle, SineMethod method);
/// Bit for bit sine(angle + kQuarterTurn, method).
Unit cosine(Angle angle, SineMethod method);

}  // namespace oblong
