#pragma once

#include "engine/fixed/arithmetic.h"
#include "engine/io/doubles.h"
#include "engine/math/vec.h"
#include "engine/reference/vec.h"

/// The engine's numbers as doubles, for comparisons.
namespace oblong {

inline double number_of(Ratio ratio) {
    return static_cast<double>(ratio.numerator) / static_cast<double>(ratio.denominator);
}

template <class Int, int Frac>
reference::Vec vec_of(const Vec3<Fixed<Int, Frac>>& v) {
    return {number_of(v.x), number_of(v.y), number_of(v.z)};
}

}  // namespace oblong
