#include "engine/math/transform.h"

#include "engine/math/vec.h"

namespace oblong {

namespace {

constexpr Unit kWholeUnit = Unit::from_int(1);
constexpr Vec3<Unit> kAxisX{kWholeUnit, {}, {}}, kAxisY{{}, kWholeUnit, {}}, kAxisZ{{}, {}, kWholeUnit};

std::array<Entry, 3> entries_of(const Vec3<Unit>& v) {
    return {convert<Entry>(v.x), convert<Entry>(v.y), convert<Entry>(v.z)};
}

/// The matrix whose columns are these.
Matrix3 matrix_of_columns(const Vec3<Unit>& x, const Vec3<Unit>& y, const Vec3<Unit>& z) {
    return Matrix3{{entries_of(x), entries_of(y), entries_of(z)}}.transposed();
}

}  // namespace

Matrix3 rotation_matrix(const Vec3<Unit>& axis, Angle angle) {
    return matrix_of_columns(rotate_about_axis(kAxisX, axis, angle), rotate_about_axis(kAxisY, axis, angle),
                             rotate_about_axis(kAxisZ, axis, angle));
}

Matrix3 rotation_matrix(const Quaternion& rotation) {
    return matrix_of_columns(rotate(kAxisX, rotation), rotate(kAxisY, rotation), rotate(kAxisZ, rotation));
}

Matrix3 rotation_matrix(const EulerAngles& angles) {
    const Basis axes = view_basis(angles.yaw, angles.pitch, angles.roll);
    return matrix_of_columns(axes.forward, -axes.right, axes.up);
}

Quaternion quaternion_of(const EulerAngles& angles) {
    return quaternion_about_axis(kAxisZ, angles.yaw) *
           (quaternion_about_axis(kAxisY, angles.pitch) * quaternion_about_axis(kAxisX, angles.roll));
}

Matrix4 homogeneous(const Matrix3& linear) {
    Matrix4 result = Matrix4::identity();
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result.rows[i][j] = linear.rows[i][j];
    return result;
}

Matrix3 linear_part(const Matrix4& matrix) {
    Matrix3 result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result.rows[i][j] = matrix.rows[i][j];
    return result;
}

Matrix4 model_matrix(const Vec3<World>& world_position, const Matrix3& rotation, const Vec3<Entry>& scale) {
    return translation(convert<Entry>(world_position)) * homogeneous(rotation) * scaling(scale);
}

Matrix4 model_matrix(const Vec3<World>& world_position, const EulerAngles& angles, const Vec3<Entry>& scale) {
    return model_matrix(world_position, rotation_matrix(angles), scale);
}

Vec3<World> transformed_point(const Matrix4& model_to_world, const Vec3<World>& model_point) {
    const Vec4 world = model_to_world * Vec4{convert<Entry>(model_point.x), convert<Entry>(model_point.y),
                                             convert<Entry>(model_point.z)};
    return saturating_convert<World>(Vec3<Entry>{world.x, world.y, world.z});
}

Vec3<Unit> transformed_normal(const Matrix3& normal_to_world, const Vec3<Unit>& model_normal) {
    return normalised(normal_to_world * convert<Entry>(model_normal));
}

}  // namespace oblong
