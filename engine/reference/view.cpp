#include "engine/reference/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace oblong::reference {
namespace {

constexpr double kRadians = std::numbers::pi / 32768;

Axes make_world_axes(const View& view) {
    const double sin_yaw = std::sin(view.yaw * kRadians), cos_yaw = std::cos(view.yaw * kRadians);
    const double sin_pitch = std::sin(view.pitch * kRadians), cos_pitch = std::cos(view.pitch * kRadians);
    const double sin_roll = std::sin(view.roll * kRadians), cos_roll = std::cos(view.roll * kRadians);
    const Vec level_forward{cos_yaw, sin_yaw, 0}, level_right{sin_yaw, -cos_yaw, 0}, vertical{0, 0, 1};
    const Vec forward = level_forward * cos_pitch - vertical * sin_pitch;
    const Vec up = vertical * cos_pitch + level_forward * sin_pitch;
    return {level_right * cos_roll - up * sin_roll, up * cos_roll + level_right * sin_roll, forward};
}

/// The least distance of the eye from a plane, units. A nearer face, or one visible only by rounding, is a sliver for
/// which any steep view will do.
constexpr double kLeastDistance = 1e-6;
/// Sine of the least angle, roughly, at which rows of a matrix count as independent.
constexpr double kLeastSine = 1e-12;

}  // namespace

Camera make_camera(const View& view) {
    Projection projection = make_projection(view.width_px, view.height_px, view.display, view.field_of_view);
    if (!view.correct_aspect) projection.multiplier_y = projection.multiplier_x;
    return {view.eye, make_world_axes(view), projection};
}

Projection make_projection(double width_px, double height_px, double display, double field_of_view) {
    const double d = width_px / 2 / std::tan(field_of_view * std::numbers::pi / 360);
    return {width_px, height_px, d, d * display * height_px / width_px};
}

ScreenPoint project(const Vec& view, const Projection& projection) {
    return {projection.width_px / 2 + projection.multiplier_x * view.x / view.z,
            projection.height_px / 2 - projection.multiplier_y * view.y / view.z};
}

Vec to_view(const Vec& world_point, const Vec& world_eye, const Axes& axes) {
    const Vec offset = world_point - world_eye;
    return {dot(offset, axes.right), dot(offset, axes.up), dot(offset, axes.forward)};
}

PlaneView::Linear PlaneView::along_ray(const Vec& axis, const Camera& camera) {
    return {dot(axis, camera.axes.right) / camera.projection.multiplier_x,
            -dot(axis, camera.axes.up) / camera.projection.multiplier_y, dot(axis, camera.axes.forward)};
}

PlaneView::PlaneView(const Level& level, const Face& face, const Vec& offset, const Camera& camera)
    : centre_{camera.projection.width_px / 2, camera.projection.height_px / 2} {
    const TexInfo& texinfo = level.texinfo_of(face);
    const Vec eye = camera.eye - offset;
    eye_u_ = dot(texinfo.s, eye) + texinfo.s_offset;
    eye_v_ = dot(texinfo.t, eye) + texinfo.t_offset;
    u_along_ray_ = along_ray(texinfo.s, camera);
    v_along_ray_ = along_ray(texinfo.t, camera);
    const double distance = std::max(dot(face.plane.normal, eye) - face.plane.offset, kLeastDistance);
    inverse_z_ = along_ray(face.plane.normal * (-1 / distance), camera);
}

Texel PlaneView::texel_at(ScreenPoint at, double inverse_z) const {
    const ScreenPoint p = from_centre(at);
    return {eye_u_ + u_along_ray_.at(p) / inverse_z, eye_v_ + v_along_ray_.at(p) / inverse_z, inverse_z};
}

std::optional<ScreenPoint> PlaneView::place_of(double u, double v) const {
    // Three linear equations: u_along_ray z = u - eye_u, v_along_ray z = v - eye_v, inverse_z z = 1, for X z, Y z and
    // z.
    const auto row = [](const Linear& linear) { return Vec{linear.x, linear.y, linear.constant}; };
    const Vec a = row(u_along_ray_), b = row(v_along_ray_), c = row(inverse_z_);
    const double determinant = dot(a, cross(b, c));
    if (std::abs(determinant) <= kLeastSine * std::sqrt(dot(a, a) * dot(b, b) * dot(c, c))) return std::nullopt;
    const Vec solution = (cross(b, c) * (u - eye_u_) + cross(c, a) * (v - eye_v_) + cross(a, b)) * (1 / determinant);
    if (!(solution.z > 0)) return std::nullopt;
    return ScreenPoint{centre_.x + solution.x / solution.z, centre_.y + solution.y / solution.z};
}

}  // namespace oblong::reference
