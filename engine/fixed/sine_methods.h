#pragma once

#include <array>

#include "engine/fixed/angle.h"
#include "engine/fixed/fixed.h"

namespace oblong {

/// How a sine is found: what games of the time did, beside the engine's own (fixed/trig.h). The error is the worst
/// over all binary angles.
enum class SineMethod {
    Nearest256,       ///< the nearest of 256 entries to the turn: 2^-6.3
    Nearest1024,      ///< of 1,024: 2^-8.3
    Nearest4096,      ///< of 4,096: 2^-10.3
    Lerp256,          ///< a straight line between two of 256: 2^-13.6
    Lerp1024,         ///< of 1,024: 2^-17.6
    Quarter1024Lerp,  ///< a line between two of 1,024 to the quarter turn: 2^-21.6; odd, bit for bit
    Cordic16,         ///< 16 rotations by arctan 2^-i, shifts and sums only: 2^-15
    Cordic24,         ///< 24: 2^-22.9
    Cordic30,         ///< 30: 2^-26
    NearestStep       ///< the nearest step of 2^-30
};

inline constexpr std::array kSineMethods = {
    SineMethod::Nearest256,      SineMethod::Nearest1024, SineMethod::Nearest4096, SineMethod::Lerp256,
    SineMethod::Lerp1024,        SineMethod::Cordic16,    SineMethod::Cordic24,    SineMethod::Cordic30,
    SineMethod::Quarter1024Lerp, SineMethod::NearestStep};

/// "nearest of 256", "CORDIC, 16 steps", ...
const char* name_of(SineMethod method);

Unit sine(Angle angle, SineMethod method);
/// Bit for bit sine(angle + kQuarterTurn, method).
Unit cosine(Angle angle, SineMethod method);

}  // namespace oblong
