#pragma once

#include <cmath>

#include "engine/fixed/fixed.h"

namespace oblong {

/// A number as a double, for reading, reports and comparisons.
template <class Int, int Frac>
double number_of(Fixed<Int, Frac> value) {
    return std::ldexp(static_cast<double>(value.raw), -Frac);
}

/// The nearest number of a format.
template <class To>
To fixed_of(double value) {
    return To::from_raw(static_cast<typename To::Raw>(std::llround(std::ldexp(value, To::kFractionBits))));
}

}  // namespace oblong
