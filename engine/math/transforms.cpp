#include "engine/math/transforms.h"

#include "engine/math/vec.h"

namespace oblong {

namespace {

std::array<Entry, 4> row_of(const Vec3<Unit>& axis, Entry last) {
    return {convert<Entry>(axis.x), convert<Entry>(axis.y), convert<Entry>(axis.z), last};
}

}  // namespace

Matrix4 translation(const Vec3<Entry>& by) {
    Matrix4 result = Matrix4::identity();
    result.rows[0][3] = by.x;
    result.rows[1][3] = by.y;
    result.rows[2][3] = by.z;
    return result;
}

Matrix4 scaling(const Vec3<Entry>& by) {
    Matrix4 result = Matrix4::identity();
    result.rows[0][0] = by.x;
    result.rows[1][1] = by.y;
    result.rows[2][2] = by.z;
    return result;
}

Matrix3 rotation_matrix(const Basis& basis) {
    Matrix3 result;
    const std::array axes{basis.right, basis.up, basis.forward};
    for (std::size_t i = 0; i < 3; ++i)
        result.rows[i] = {convert<Entry>(axes[i].x), convert<Entry>(axes[i].y), convert<Entry>(axes[i].z)};
    return result;
}

Matrix4 view_matrix(const Basis& basis, const Vec3<World>& world_eye) {
    const auto row = [&world_eye](const Vec3<Unit>& axis) {
        return row_of(axis, convert<Entry>(-dot(world_eye, axis)));
    };
    return {{row(basis.right), row(basis.up), row(basis.forward), Matrix4::identity().rows[3]}};
}

Matrix4 camera_matrix(const Basis& basis, const Vec3<World>& world_eye) {
    Matrix4 columns;
    columns.rows = {
        row_of(basis.right, {}),
        row_of(basis.up, {}),
        row_of(basis.forward, {}),
        {convert<Entry>(world_eye.x), convert<Entry>(world_eye.y), convert<Entry>(world_eye.z), Entry::from_int(1)}};
    return columns.transposed();
}

std::optional<Matrix3> normal_matrix(const Matrix3& model_to_world) {
    const std::optional<Matrix3> inverted = inverse(model_to_world);
    if (!inverted) return std::nullopt;
    return inverted->transposed();
}

}  // namespace oblong
