#pragma once

#include "engine/fixed/trig.h"

namespace oblong {

/// An angle finer than a binary one, for blending rotations. 4.60.
using Radians = Fixed<std::int64_t, 60>;

/// The angle, 0 to pi / 2, with this sine and cosine (neither negative, their squares adding up to 1); within 2^-56.
Radians radians_of(const SineCosine60& unit_vector);

/// The sine of 0 to pi / 2; within 2^-57.
Sine60 sine(Radians angle);

}  // namespace oblong
