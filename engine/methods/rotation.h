#pragma once

#include "engine/fixed/angle.h"
#include "engine/math/basis.h"
#include "engine/math/vec.h"

namespace oblong {

/// A direction turned about an axis of length 1, counter-clockwise as seen with the axis pointing at the viewer (in
/// right-handed axes). Rodrigues' formula, rounded once.
Vec3<Unit> rotate_about_axis(const Vec3<Unit>& direction, const Vec3<Unit>& axis, Angle angle);
Basis rotate_about_axis(const Basis& basis, const Vec3<Unit>& axis, Angle angle);

/// Rotation by projection onto axes (Abrash): the direction's coordinates along right, up and forward.
Vec3<Unit> project_onto_axes(const Vec3<Unit>& direction, const Basis& axes);
/// The inverse: the direction with these coordinates along right, up and forward.
Vec3<Unit> sum_along_axes(const Vec3<Unit>& coordinates, const Basis& axes);

/// A rotation: w + x i + y j + z k of length 1, each component 2.30. q and -q are the same rotation.
struct Quaternion {
    Unit w = Unit::from_int(1), x, y, z;

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

}  // namespace oblong
