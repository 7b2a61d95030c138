#pragma once

#include <cmath>

#include "engine/math/vec.h"
#include "tools/reference/vec.h"

/// The engine's numbers in doubles, for what is compared with doubles.
namespace oblong {

template <class Int, int Frac>
double number_of(Fixed<Int, Frac> value) {
    return std::ldexp(static_cast<double>(value.raw), -Frac);
}

template <class Int, int Frac>
reference::Vec vec_of(const Vec3<Fixed<Int, Frac>>& v) {
    return {number_of(v.x), number_of(v.y), number_of(v.z)};
}

}  // namespace oblong
