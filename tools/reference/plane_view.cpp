#include "tools/reference/plane_view.h"

#include <algorithm>
#include <cmath>

namespace oblong::reference {

namespace {

/// The least distance of the eye from a plane, units. A nearer face, or one visible only by rounding, is a sliver for
/// which any steep view will do.
constexpr double kLeastDistance = 1e-6;
/// Sine of the least angle, roughly, at which rows of a matrix count as independent.
constexpr double kLeastSine = 1e-12;

}  // namespace

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
