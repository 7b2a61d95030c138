#pragma once

#include "engine/fixed/angle.h"
#include "engine/math/matrix.h"

namespace oblong {

/// Angles of an orientation, as levels and cameras give them: yaw counter-clockwise from +x seen from above, pitch
/// positive looking down, roll positive leaning right. Applied in the order roll (about x), pitch (about y), yaw
/// (about z), each about the world's own axis: the matrix is Rz(yaw) Ry(pitch) Rx(roll).
struct EulerAngles {
    Angle yaw, pitch, roll;
    constexpr bool operator==(const EulerAngles&) const = default;
};

/// The matrix whose columns are these: where the x, y and z axis go.
Matrix3 matrix_of_columns(const Vec3<Unit>& x, const Vec3<Unit>& y, const Vec3<Unit>& z);
/// A rotation, its entries those of view_basis(), bit for bit.
Matrix3 rotation_matrix(const EulerAngles& angles);

/// A linear map as one that also moves points: by nothing.
Matrix4 homogeneous(const Matrix3& linear);
/// A point as a homogeneous vector: w is 1.
template <class Number>
Vec4 homogeneous(const Vec3<Number>& point) {
    return {convert<Entry>(point.x), convert<Entry>(point.y), convert<Entry>(point.z)};
}
/// What a matrix does to directions: its upper left 3x3.
Matrix3 linear_part(const Matrix4& matrix);

/// Model to world: scaled along the model's own axes, then turned, then moved (each step a matrix; this is their
/// product). A scale below 0 mirrors, which turns the winding of triangles around. Entries saturate: a scale is below
/// 2^30.
Matrix4 model_matrix(const Vec3<World>& world_position, const Matrix3& rotation, const Vec3<Entry>& scale);
Matrix4 model_matrix(const Vec3<World>& world_position, const EulerAngles& angles, const Vec3<Entry>& scale);

}  // namespace oblong
