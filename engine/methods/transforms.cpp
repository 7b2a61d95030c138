#include "engine/methods/transforms.h"

#include "engine/math/vec.h"
#include "engine/methods/rotation.h"

namespace oblong {

namespace {

constexpr Unit kWholeUnit = Unit::from_int(1);
constexpr Vec3<Unit> kAxisX{kWholeUnit, {}, {}}, kAxisY{{}, kWholeUnit, {}}, kAxisZ{{}, {}, kWholeUnit};

}  // namespace

std::optional<Vec3<Entry>> point_of(const Vec4& homogeneous) {
    if (homogeneous.w == Entry{}) return std::nullopt;
    return Vec3<Entry>{divide<Entry>(homogeneous.x, homogeneous.w), divide<Entry>(homogeneous.y, homogeneous.w),
                       divide<Entry>(homogeneous.z, homogeneous.w)};
}

Matrix3 rotation_matrix(const Basis& basis) {
    Matrix3 result;
    const std::array axes{basis.right, basis.up, basis.forward};
    for (std::size_t i = 0; i < 3; ++i)
        result.rows[i] = {convert<Entry>(axes[i].x), convert<Entry>(axes[i].y), convert<Entry>(axes[i].z)};
    return result;
}

Matrix4 camera_matrix(const Basis& basis, const Vec3<World>& world_eye) {
    return translation(convert<Entry>(world_eye)) * homogeneous(rotation_matrix(basis).transposed());
}

Matrix3 rotation_matrix(const Vec3<Unit>& axis, Angle angle) {
    return matrix_of_columns(rotate_about_axis(kAxisX, axis, angle), rotate_about_axis(kAxisY, axis, angle),
                             rotate_about_axis(kAxisZ, axis, angle));
}

Matrix3 rotation_matrix(const Quaternion& rotation) {
    return matrix_of_columns(rotate(kAxisX, rotation), rotate(kAxisY, rotation), rotate(kAxisZ, rotation));
}

Quaternion quaternion_of(const EulerAngles& angles) {
    return quaternion_about_axis(kAxisZ, angles.yaw) *
           (quaternion_about_axis(kAxisY, angles.pitch) * quaternion_about_axis(kAxisX, angles.roll));
}

Vec3<World> transformed_point(const Matrix4& model_to_world, const Vec3<World>& model_point) {
    const Vec4 world = model_to_world * homogeneous(model_point);
    return saturating_convert<World>(Vec3<Entry>{world.x, world.y, world.z});
}

}  // namespace oblong
