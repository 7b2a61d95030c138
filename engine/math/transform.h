#pragma once

#include <optional>

#include "engine/fixed/angle.h"
#include "engine/math/matrix.h"
#include "engine/math/rotation.h"

namespace oblong {

/// Angles of an orientation, as levels and cameras give them: yaw counter-clockwise from +x seen from above, pitch
/// positive looking down, roll positive leaning right. Applied in the order roll (about x), pitch (about y), yaw
/// (about z), each about the world's own axis: the matrix is Rz(yaw) Ry(pitch) Rx(roll).
struct EulerAngles {
    Angle yaw, pitch, roll;
    constexpr bool operator==(const EulerAngles&) const = default;
};

// Rotations as matrices: columns are where the x, y and z axis go. Entries are those of the vectors that rotation.h
// and basis.h turn, so that the three agree with them bit for bit.

/// About an axis of length 1, counter-clockwise with the axis pointing at the viewer (right-handed axes).
Matrix3 rotation_matrix(const Vec3<Unit>& axis, Angle angle);
/// Of a quaternion of length 1.
Matrix3 rotation_matrix(const Quaternion& rotation);
Matrix3 rotation_matrix(const EulerAngles& angles);

/// The quaternion of the same rotation: the product of three, about z, y and x.
Quaternion quaternion_of(const EulerAngles& angles);

/// A linear map as one that also moves points: by nothing.
Matrix4 homogeneous(const Matrix3& linear);
/// What a matrix does to directions: its upper left 3x3.
Matrix3 linear_part(const Matrix4& matrix);

/// Model to world: scaled along the model's own axes, then turned, then moved (each step a matrix; this is their
/// product). A scale below 0 mirrors, which turns the winding of triangles around. Entries saturate: a scale is below
/// 2^30.
Matrix4 model_matrix(const Vec3<World>& world_position, const Matrix3& rotation, const Vec3<Entry>& scale);
Matrix4 model_matrix(const Vec3<World>& world_position, const EulerAngles& angles, const Vec3<Entry>& scale);

/// A model's point in the world, rounded once each coordinate; saturates.
Vec3<World> transformed_point(const Matrix4& model_to_world, const Vec3<World>& model_point);
/// A normal in the world, of length 1, by normal_matrix() of the model's transform.
Vec3<Unit> transformed_normal(const Matrix3& normal_to_world, const Vec3<Unit>& model_normal);

}  // namespace oblong
