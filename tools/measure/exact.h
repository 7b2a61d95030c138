#pragma once

#include <cmath>

#include "engine/fixed/ratio.h"
#include "engine/math/vec.h"
#include "tools/reference/vec.h"

/// The engine's numbers in doubles and back, for what is compared with doubles.
namespace oblong {

template <class Int, int Frac>
double number_of(Fixed<Int, Frac> value) {
    return std::ldexp(static_cast<double>(value.raw), -Frac);
}

inline double number_of(Ratio ratio) {
    return static_cast<double>(ratio.numerator) / static_cast<double>(ratio.denominator);
}

/// The nearest number of a fixed-point type.
template <class Number>
Number fixed_of(double value) {
    return Number::from_raw(static_cast<decltype(Number::raw)>(std::llround(std::ldexp(value, Number::kFractionBits))));
}

template <class Int, int Frac>
reference::Vec vec_of(const Vec3<Fixed<Int, Frac>>& v) {
    return {number_of(v.x), number_of(v.y), number_of(v.z)};
}

}  // namespace oblong
