#include "engine/math/transform.h"

#include "engine/math/vec.h"

namespace oblong {

namespace {

std::array<Entry, 3> entries_of(const Vec3<Unit>& v) {
    return {convert<Entry>(v.x), convert<Entry>(v.y), convert<Entry>(v.z)};
}

}  // namespace

Matrix3 matrix_of_columns(const Vec3<Unit>& x, const Vec3<Unit>& y, const Vec3<Unit>& z) {
    return Matrix3{{entries_of(x), entries_of(y), entries_of(z)}}.transposed();
}

Matrix3 rotation_matrix(const EulerAngles& angles) {
    const Basis axes = view_basis(angles.yaw, angles.pitch, angles.roll);
    return matrix_of_columns(axes.forward, -axes.right, axes.up);
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
    // translation * rotation * scaling, without their products by 0 and by 1.
    Matrix4 result = translation(convert<Entry>(world_position));
    const std::array scales{scale.x, scale.y, scale.z};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result.rows[i][j] = multiply(rotation.rows[i][j], scales[j]);
    return result;
}

Matrix4 model_matrix(const Vec3<World>& world_position, const EulerAngles& angles, const Vec3<Entry>& scale) {
    return model_matrix(world_position, rotation_matrix(angles), scale);
}

}  // namespace oblong
