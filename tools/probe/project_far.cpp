#include "tools/probe/project_far.h"

#include <algorithm>

#include "engine/fixed/sine_series.h"
#include "engine/methods/axes.h"

namespace oblong {

namespace {

constexpr SoftFloat whole(std::int64_t value) {
    return SoftFloat::from(value, 0);
}

/// first - first x^2 / (n (n+1)) + first x^4 / (n (n+1) (n+2) (n+3)) - ..., until the terms vanish.
SoftFloat alternating_series(const SoftFloat& first, const SoftFloat& x_squared, std::int64_t n) {
    SoftFloat sum = first, term = first;
    for (; !term.is_zero() && term.magnitude() > first.magnitude() - 64; n += 2) {
        term = -(term * x_squared) / whole(n * (n + 1));
        sum = sum + term;
    }
    return sum;
}

/// Of 0 to 90 degrees, exact relative to itself however small.
SoftFloat tangent_of_half(const SoftFloat& degrees) {
    const SoftFloat x = degrees * SoftFloat::from(detail::kRadiansPerDegree68, -68 - 1);
    return alternating_series(x, x * x, 2) / alternating_series(whole(1), x * x, 1);
}

SoftFloat cotangent_of_half(const SoftFloat& degrees) {
    const SoftFloat beyond_right_angle = degrees - whole(90);
    if (beyond_right_angle.mantissa > 0) return tangent_of_half(whole(180) - degrees);
    return whole(1) / tangent_of_half(degrees);
}

SoftFloat along(const Vec3<Sine60>& axis, const Vec3<SoftFloat>& offset) {
    const auto product = [](Sine60 component, const SoftFloat& distance) {
        return SoftFloat::from(component) * distance;
    };
    return product(axis.x, offset.x) + product(axis.y, offset.y) + product(axis.z, offset.z);
}

std::optional<ScreenWide> project_axis(const SoftFloat& multiplier, const SoftFloat& view, const SoftFloat& z,
                                       ScreenWide centre) {
    const auto offset = fixed_of<ScreenWide>(multiplier * view / z);
    if (!offset) return std::nullopt;
    return centre + *offset;
}

}  // namespace

FarProjection make_far_projection(const ScreenMode& mode, const SoftFloat& field_of_view_degrees) {
    const Ratio shape = mode.display * Ratio{mode.height_px, mode.width_px};
    FarProjection projection;
    projection.x = SoftFloat::from(mode.width_px, -1) * cotangent_of_half(field_of_view_degrees);
    projection.y = projection.x * whole(shape.numerator) / whole(shape.denominator);
    projection.centre_x = ScreenWide::from_raw(std::int64_t{mode.width_px} * 128);
    projection.centre_y = ScreenWide::from_raw(std::int64_t{mode.height_px} * 128);
    return projection;
}

FarPoint to_far_view(const Vec3<World>& world_point, const Vec3<World>& world_eye, const FineBasis& basis) {
    const auto from_eye = widening_difference(world_point, world_eye);
    const Vec3<SoftFloat> offset{SoftFloat::from(from_eye.x), SoftFloat::from(from_eye.y), SoftFloat::from(from_eye.z)};
    return {along(basis.right, offset), along(basis.up, offset), along(basis.forward, offset)};
}

FarPoint to_far_view(const Vec3<View>& view_point) {
    return {SoftFloat::from(view_point.x), SoftFloat::from(view_point.y), SoftFloat::from(view_point.z)};
}

std::optional<ScreenPosition> project_far(const FarPoint& point, const FarProjection& projection) {
    const auto x = project_axis(projection.x, point.x, point.z, projection.centre_x);
    const auto y = project_axis(projection.y, -point.y, point.z, projection.centre_y);
    if (!x || !y) return std::nullopt;
    return ScreenPosition{*x, *y};
}

bool is_exact_in_frame(const Vec3<View>& view_point, const Frustum& frustum, const Projection& projection) {
    // Half a step of View moves a point at z = reach / 64 by up to 2^-11 pixel.
    const std::int64_t half_screen_16 = std::int64_t{std::max(projection.width_px, projection.height_px)} << 15;
    const View reach = std::max(projection.x.coarse, projection.y.coarse) + View::from_raw(half_screen_16);
    return outcode_of(frustum, view_point) == 0 && view_point.z >= floor_shift(reach, 6);
}

}  // namespace oblong
