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

TexelGradient PlaneView::gradient_at(ScreenPoint at) const {
    const ScreenPoint p = from_centre(at);
    const double inverse = inverse_z_.at(p);
    // The derivative of a quotient of two linear functions.
    const auto slope = [&](double of_numerator, double numerator, double of_inverse) {
        return (of_numerator - numerator / inverse * of_inverse) / inverse;
    };
    const double u = u_along_ray_.at(p), v = v_along_ray_.at(p);
    return {slope(u_along_ray_.x, u, inverse_z_.x), slope(v_along_ray_.x, v, inverse_z_.x),
            slope(u_along_ray_.y, u, inverse_z_.y), slope(v_along_ray_.y, v, inverse_z_.y)};
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

Texel texel_at(const std::array<TexturedCorner, 3>& corners, const Projection& projection, ScreenPoint at) {
    const Vec ray{(at.x - projection.width_px / 2) / projection.multiplier_x,
                  (projection.height_px / 2 - at.y) / projection.multiplier_y, 1};
    const Vec &a = corners[0].position, &b = corners[1].position, &c = corners[2].position;
    const double weights[] = {dot(cross(b, c), ray), dot(cross(c, a), ray), dot(cross(a, b), ray)};
    const double sum = weights[0] + weights[1] + weights[2];
    Texel texel{0, 0, sum / dot(a, cross(b, c))};
    for (std::size_t i = 0; i < 3; ++i) {
        texel.u += weights[i] * corners[i].u / sum;
        texel.v += weights[i] * corners[i].v / sum;
    }
    return texel;
}

}  // namespace oblong::reference
