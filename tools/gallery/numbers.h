#pragma once

#include <cmath>
#include <string>

#include "engine/math/matrix.h"

namespace oblong {

// The engine's numbers from doubles and back: what rows draw is worked out in doubles.

/// A point of the world, from units.
Vec3<World> world_point(double x, double y, double z);
/// The direction of (x, y, z), of length 1; not of the zero vector.
Vec3<Unit> unit_vector(double x, double y, double z);
/// A number of a matrix.
Entry entry_of(double value);

/// The value of a fixed-point number.
template <class Int, int Frac>
double number_of(Fixed<Int, Frac> value) {
    return std::ldexp(static_cast<double>(value.raw), -Frac);
}

/// A number as text: "%.3f" or another format.
std::string decimal_text(double value, const char* format = "%.3f");

}  // namespace oblong
