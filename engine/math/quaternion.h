#pragma once

#include "engine/fixed/angle.h"
#include "engine/math/basis.h"
#include "engine/math/vec.h"

namespace oblong {

/// A rotation: w + x i + y j + z k of length 1, each component 2.30. q and -q are the same rotation.
struct Quaternion {
    Unit w = Unit::from_int(1), x, y, z;

    constexpr Quaternion operator-() const { return {-w, -x, -y, -z}; }
    constexpr Quaternion conjugate() const { return {w, -x, -y, -z}; }
    constexpr bool operator==(const Quaternion&) const = default;
};

/// The rotation by `angle` about an axis of length 1, counter-clockwise with the axis pointing at the viewer
/// (right-handed axes).
Quaternion quaternion_about_axis(const Vec3<Unit>& axis, Angle angle);

/// Hamilton's product of two rotations: first b, then a. Each component is rounded once.
Quaternion operator*(const Quaternion& a, const Quaternion& b);

/// The quaternion of length 1 in this direction; the zero quaternion stays zero.
Quaternion normalised(const Quaternion& quaternion);

Vec3<Unit> rotate(const Vec3<Unit>& direction, const Quaternion& rotation);
Basis rotate(const Basis& basis, const Quaternion& rotation);

/// The rotation on the shorter arc from `from` (t = 0) to `to` (t = 1), at constant speed (Shoemake). `t` is cut to
/// 0..1; the ends are `from` and `to` bit for bit, and results between have length 1 within 2^-28. Where the two are
/// nearer than 1 - |dot| = 2^-16 the interpolation is linear.
Quaternion slerp(const Quaternion& from, const Quaternion& to, Unit t);

}  // namespace oblong
