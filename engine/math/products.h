#pragma once

#include "engine/fixed/fixed.h"
#include "engine/math/vec.h"

namespace oblong {

/// The exact dot product of vectors of 32-bit numbers (Muratori: |a| |b| cos of the angle between them, as long as the
/// axes are at right angles and of equal length). Units with units give 4.60, world positions with units
/// PlaneDistance. The true value must fit 64 bits: by Cauchy's inequality it does for any world position and a unit
/// vector, and for world positions within +-2^17 units of each other.
template <class A, int FracA, class B, int FracB>
constexpr auto dot(const Vec3<Fixed<A, FracA>>& a, const Vec3<Fixed<B, FracB>>& b) {
    return widening_product(a.x, b.x) + widening_product(a.y, b.y) + widening_product(a.z, b.z);
}

/// The exact cross product: at right angles to both; its length is |a| |b| sin of the angle from a to b. The formula
/// gives x cross y = z in right-handed and in left-handed axes alike. The same bounds as dot().
template <class A, int FracA, class B, int FracB>
constexpr auto cross(const Vec3<Fixed<A, FracA>>& a, const Vec3<Fixed<B, FracB>>& b) {
    using Product = Fixed<std::int64_t, FracA + FracB>;
    return Vec3<Product>{widening_product(a.y, b.z) - widening_product(a.z, b.y),
                         widening_product(a.z, b.x) - widening_product(a.x, b.z),
                         widening_product(a.x, b.y) - widening_product(a.y, b.x)};
}

}  // namespace oblong
