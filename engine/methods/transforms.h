#pragma once

#include <optional>

#include "engine/math/transform.h"
#include "engine/methods/rotation.h"

namespace oblong {

/// The point of a homogeneous vector; none for a direction. Each coordinate saturates.
std::optional<Vec3<Entry>> point_of(const Vec4& homogeneous);

/// The rotation whose rows are right, up and forward: world directions to view directions.
Matrix3 rotation_matrix(const Basis& basis);

/// View to world, its inverse: the columns are the axes and the eye.
Matrix4 camera_matrix(const Basis& basis, const Vec3<World>& world_eye);

// Rotations as matrices: their columns are the images of the x, y and z axis. The entries are those of
// methods/rotation.h and basis.h, bit for bit.

/// About an axis of length 1, counter-clockwise with the axis pointing at the viewer (right-handed axes).
Matrix3 rotation_matrix(const Vec3<Unit>& axis, Angle angle);
/// Of a quaternion of length 1.
Matrix3 rotation_matrix(const Quaternion& rotation);

/// The quaternion of the same rotation: the product of three, about z, y and x.
Quaternion quaternion_of(const EulerAngles& angles);

/// A model's point in the world, rounded once each coordinate; saturates.
Vec3<World> transformed_point(const Matrix4& model_to_world, const Vec3<World>& model_point);

}  // namespace oblong
