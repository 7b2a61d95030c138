#pragma once

#include "engine/fixed/angle.h"
#include "engine/math/matrix.h"

namespace oblong {

/// An orientation, as in levels and cameras: yaw counter-clockwise from +x seen from above, pitch positive looking
/// down, roll positive leaning right. Applied in the order roll (about x), pitch (about y), yaw (about z), each about
/// the world's axis: the matrix is Rz(yaw) Ry(pitch) Rx(roll).
struct EulerAngles {
    Angle yaw, pitch, roll;
    constexpr bool operator==(const EulerAngles&) const = default;
};

/// The matrix with these columns, the images of the x, y and z axis.
Matrix3 matrix_of_columns(const Vec3<Unit>& x, const Vec3<Unit>& y, const Vec3<Unit>& z);
/// A rotation; the entries equal those of view_basis(), bit for bit.
Matrix3 rotation_matrix(const EulerAngles& angles);

/// A linear map as an affine one without translation.
Matrix4 homogeneous(const Matrix3& linear);
/// A point as a homogeneous vector with w = 1.
template <class Number>
Vec4 homogeneous(const Vec3<Number>& point) {
    return {convert<Entry>(point.x), convert<Entry>(point.y), convert<Entry>(point.z)};
}
/// The upper left 3x3, which transforms directions.
Matrix3 linear_part(const Matrix4& matrix);

/// Model to world: the product of scaling along the model's axes, rotation and translation, applied in this order. A
/// negative scale mirrors, which reverses the winding of triangles. Scales are below 2^30; entries saturate.
Matrix4 model_matrix(const Vec3<World>& world_position, const Matrix3& rotation, const Vec3<Entry>& scale);
Matrix4 model_matrix(const Vec3<World>& world_position, const EulerAngles& angles, const Vec3<Entry>& scale);

}  // namespace oblong
