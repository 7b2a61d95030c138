#include "engine/methods/transforms.h"

#include <algorithm>
#include <array>

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/trig.h"
#include "engine/fixed/wide.h"
#include "engine/math/vec.h"

namespace oblong {
namespace {

using Vec60 = Vec3<Sine60>;

Sine60 times(Unit a, Sine60 b) {
    return product<Sine60>(a, b);
}

template <class Number>
Vec60 scaled(const Vec3<Number>& v, Sine60 factor) {
    return {product<Sine60>(v.x, factor), product<Sine60>(v.y, factor), product<Sine60>(v.z, factor)};
}

constexpr Unit kWholeUnit = Unit::from_int(1);
constexpr Vec3<Unit> kAxisX{kWholeUnit, {}, {}}, kAxisY{{}, kWholeUnit, {}}, kAxisZ{{}, {}, kWholeUnit};

}  // namespace

Vec3<Unit> rotate_about_axis(const Vec3<Unit>& direction, const Vec3<Unit>& axis, Angle angle) {
    const auto [sine60, cosine60] = sine_cosine(angle);
    const Sine60 along_axis = product<Sine60>(dot(axis, direction), Sine60::from_int(1) - cosine60);
    return saturating_convert<Unit>(scaled(direction, cosine60) + scaled(cross(axis, direction), sine60) +
                                    scaled(axis, along_axis));
}

Basis rotate_about_axis(const Basis& basis, const Vec3<Unit>& axis, Angle angle) {
    return {.right = rotate_about_axis(basis.right, axis, angle),
            .up = rotate_about_axis(basis.up, axis, angle),
            .forward = rotate_about_axis(basis.forward, axis, angle)};
}

Vec3<Unit> project_onto_axes(const Vec3<Unit>& direction, const Basis& axes) {
    return saturating_convert<Unit>(
        Vec60{dot(direction, axes.right), dot(direction, axes.up), dot(direction, axes.forward)});
}

Vec3<Unit> sum_along_axes(const Vec3<Unit>& coordinates, const Basis& axes) {
    const auto along = [](const Vec3<Unit>& axis, Unit coordinate) {
        return Vec60{widening_product(axis.x, coordinate), widening_product(axis.y, coordinate),
                     widening_product(axis.z, coordinate)};
    };
    return saturating_convert<Unit>(along(axes.right, coordinates.x) + along(axes.up, coordinates.y) +
                                    along(axes.forward, coordinates.z));
}

Quaternion quaternion_about_axis(const Vec3<Unit>& axis, Angle angle) {
    const auto [sine60, cosine60] = half_angle_sine_cosine(angle);
    return {convert<Unit>(cosine60), convert<Unit>(times(axis.x, sine60)), convert<Unit>(times(axis.y, sine60)),
            convert<Unit>(times(axis.z, sine60))};
}

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    const auto product = [](Unit c, Unit d) { return widening_product(c, d); };
    return {saturating_convert<Unit>(product(a.w, b.w) - product(a.x, b.x) - product(a.y, b.y) - product(a.z, b.z)),
            saturating_convert<Unit>(product(a.w, b.x) + product(a.x, b.w) + product(a.y, b.z) - product(a.z, b.y)),
            saturating_convert<Unit>(product(a.w, b.y) - product(a.x, b.z) + product(a.y, b.w) + product(a.z, b.x)),
            saturating_convert<Unit>(product(a.w, b.z) + product(a.x, b.y) - product(a.y, b.x) + product(a.z, b.w))};
}

Quaternion normalised(const Quaternion& quaternion) {
    const auto unit = normalised_raw(
        std::array<std::int64_t, 4>{quaternion.w.raw, quaternion.x.raw, quaternion.y.raw, quaternion.z.raw});
    return {unit[0], unit[1], unit[2], unit[3]};
}

/// v + 2 w (u x v) + 2 u x (u x v), where u = (x, y, z): rounded once.
Vec3<Unit> rotate(const Vec3<Unit>& direction, const Quaternion& rotation) {
    const Vec3<Unit> u{rotation.x, rotation.y, rotation.z};
    const Vec3<Sine60> once = cross(u, direction);
    const Vec3<Sine60> twice{times(u.y, once.z) - times(u.z, once.y), times(u.z, once.x) - times(u.x, once.z),
                             times(u.x, once.y) - times(u.y, once.x)};
    const auto sum = [&rotation](Unit v, Sine60 first, Sine60 second) {
        const Sine60 half = times(rotation.w, first) + second;
        return saturating_convert<Unit>(convert<Sine60>(v) + half + half);
    };
    return {sum(direction.x, once.x, twice.x), sum(direction.y, once.y, twice.y), sum(direction.z, once.z, twice.z)};
}

Basis rotate(const Basis& basis, const Quaternion& rotation) {
    return {.right = rotate(basis.right, rotation),
            .up = rotate(basis.up, rotation),
            .forward = rotate(basis.forward, rotation)};
}

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

namespace {

constexpr Sine60 kOne60 = Sine60::from_int(1);

/// v - axis (axis . v), with 60 fraction bits.
Vec3<Sine60> without(const Vec3<Unit>& v, const Vec3<Unit>& axis) {
    const Sine60 along = dot(axis, v);
    const auto rest = [&along](Unit component, Unit of_axis) {
        return convert<Sine60>(component) - product<Sine60>(of_axis, along);
    };
    return {rest(v.x, axis.x), rest(v.y, axis.y), rest(v.z, axis.z)};
}

/// The direction of `v` without its part along `axis`; any perpendicular direction if nothing is left.
Vec3<Unit> direction_without(const Vec3<Unit>& v, const Vec3<Unit>& axis) {
    const Vec3<Unit> once = normalised(without(v, axis));
    if (once == Vec3<Unit>{}) return perpendicular_to(axis);
    // For nearly parallel directions the remainder is small and its rounding errors are relatively large: a second pass
    // removes them.
    return normalised(without(once, axis));
}

}  // namespace

FineBasis y_up_fine_basis(Angle yaw, Angle pitch, Angle roll) {
    const auto [sy, cy] = sine_cosine(yaw);
    const auto [sp, cp] = sine_cosine(pitch);
    const auto [sr, cr] = sine_cosine(roll);
    const Sine60 sr_sp = multiply(sr, sp), cr_sp = multiply(cr, sp);
    return {
        .right = {multiply(cr, cy) - multiply(sr_sp, sy), multiply(sr, cp), -multiply(cr, sy) - multiply(sr_sp, cy)},
        .up = {-multiply(cr_sp, sy) - multiply(sr, cy), multiply(cr, cp), multiply(sr, sy) - multiply(cr_sp, cy)},
        .forward = {multiply(cp, sy), sp, multiply(cp, cy)}};
}

Basis y_up_basis(Angle yaw, Angle pitch, Angle roll) {
    const FineBasis fine = y_up_fine_basis(yaw, pitch, roll);
    return {.right = convert<Unit>(fine.right), .up = convert<Unit>(fine.up), .forward = convert<Unit>(fine.forward)};
}

Sine60 orthonormal_flaw(const Basis& basis) {
    const std::array axes{basis.right, basis.up, basis.forward};
    Sine60 worst;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        worst = std::max(worst, absolute(dot(axes[i], axes[i]) - kOne60));
        worst = std::max(worst, absolute(dot(axes[i], axes[(i + 1) % axes.size()])));
    }
    return worst;
}

bool is_orthonormal(const Basis& basis) {
    return orthonormal_flaw(basis) <= kOrthonormalFlaw;
}

Basis orthonormalised(const Basis& basis) {
    Basis result;
    result.forward = normalised(basis.forward);
    if (result.forward == Vec3<Unit>{}) result.forward = perpendicular_to({});
    result.up = direction_without(basis.up, result.forward);
    const Vec3<Unit> right = normalised(cross(result.forward, result.up));
    result.right = dot(right, basis.right) < Sine60{} ? -right : right;
    return result;
}

}  // namespace oblong
