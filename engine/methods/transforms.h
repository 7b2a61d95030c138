#pragma once

#include <optional>

#include "engine/fixed/angle.h"
#include "engine/math/basis.h"
#include "engine/math/transform.h"
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

/// The point of a homogeneous vector; none for a direction. Each coordinate saturates.
std::optional<Vec3<Entry>> point_of(const Vec4& homogeneous);

/// The rotation whose rows are right, up and forward: world directions to view directions.
Matrix3 rotation_matrix(const Basis& basis);

/// View to world, its inverse: the columns are the axes and the eye.
Matrix4 camera_matrix(const Basis& basis, const Vec3<World>& world_eye);

// Rotations as matrices: their columns are the images of the x, y and z axis. The entries are those of
// the functions above and of basis.h, bit for bit.

/// About an axis of length 1, counter-clockwise with the axis pointing at the viewer (right-handed axes).
Matrix3 rotation_matrix(const Vec3<Unit>& axis, Angle angle);
/// Of a quaternion of length 1.
Matrix3 rotation_matrix(const Quaternion& rotation);

/// The quaternion of the same rotation: the product of three, about z, y and x.
Quaternion quaternion_of(const EulerAngles& angles);

/// A model's point in the world, rounded once each coordinate; saturates.
Vec3<World> transformed_point(const Matrix4& model_to_world, const Vec3<World>& model_point);

}  // namespace oblong
