#include <algorithm>
#include <optional>

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/root.h"
#include "engine/fixed/sine_methods.h"
#include "engine/fixed/sine_series.h"
#include "engine/methods/square_root.h"
#include "engine/methods/transforms.h"
#include "engine/view/frustum.h"
#include "engine/view/project.h"
#include "tools/probe/fields.h"
#include "tools/probe/probe.h"

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

/// A point in viewspace with 62 significant bits.
using FarPoint = Vec3<SoftFloat>;

/// A world point as seen from `world_eye`, within 2^-39 unit: to_view() with axes and products that are not rounded to
/// the frame's formats.
FarPoint to_far_view(const Vec3<World>& world_point, const Vec3<World>& world_eye, const FineBasis& basis) {
    const auto from_eye = widening_difference(world_point, world_eye);
    const Vec3<SoftFloat> offset{SoftFloat::from(from_eye.x), SoftFloat::from(from_eye.y), SoftFloat::from(from_eye.z)};
    return {along(basis.right, offset), along(basis.up, offset), along(basis.forward, offset)};
}

/// The same point, converted exactly.
FarPoint to_far_view(const Vec3<View>& view_point) {
    return {SoftFloat::from(view_point.x), SoftFloat::from(view_point.y), SoftFloat::from(view_point.z)};
}

/// The screen position of a point with z above 0, however far off the screen, by the formula of project(), with
/// relative errors of 2^-57. A frame clips such points and never projects them. None where 56 bits cannot hold the
/// position.
std::optional<ScreenPosition> project_far(const FarPoint& point, const FarProjection& projection) {
    const auto x = project_axis(projection.x, point.x, point.z, projection.centre_x);
    const auto y = project_axis(projection.y, -point.y, point.z, projection.centre_y);
    if (!x || !y) return std::nullopt;
    return ScreenPosition{*x, *y};
}

/// Whether project() is exact to 1/200 pixel: the point is in view, for which the frame's formats are made, and not so
/// near that a step of View is more than 1/1,024 pixel.
bool is_exact_in_frame(const Vec3<View>& view_point, const Frustum& frustum, const Projection& projection) {
    // Half a step of View moves a point at z = reach / 64 by up to 2^-11 pixel.
    const std::int64_t half_screen_16 = std::int64_t{std::max(projection.width_px, projection.height_px)} << 15;
    const View reach = std::max(projection.x.coarse, projection.y.coarse) + View::from_raw(half_screen_16);
    return outcode_of(frustum, view_point) == 0 && view_point.z >= floor_shift(reach, 6);
}

/// The projection of a frame, and the same with more bits, for points that no frame projects.
struct ProbeProjection {
    Projection frame;
    FarProjection far;
    Frustum frustum;

    ProbeProjection(const ModeAndView& view, const Basis& axes)
        : frame(make_projection(view.mode, view.field_of_view)),
          far(make_far_projection(view.mode, view.fine_field_of_view)),
          frustum(make_frustum(axes, frame)) {}
};

ScreenPosition position_of(const Vec3<View>& point, const FarPoint& far_point, const ProbeProjection& projection) {
    if (is_exact_in_frame(point, projection.frustum, projection.frame)) return project(point, projection.frame);
    const std::optional<ScreenPosition> position = project_far(far_point, projection.far);
    if (!position) throw Unsupported{};
    return *position;
}

std::string format_position(const ScreenPosition& position) {
    return format_fixed(position.x) + ' ' + format_fixed(position.y);
}

/// N / 65536, N from 0 to 2^31 - 1.
using Number = Fixed<std::int64_t, 16>;
// The finest formats that hold every answer: roots up to 182, reciprocals up to 65,536.
using Root = Fixed<std::int64_t, 38>;
using Reciprocal = Fixed<std::int64_t, 46>;

Angle read_only_angle(Fields& fields) {
    const Angle angle = fields.angle();
    fields.expect_end();
    return angle;
}

Number read_only_number(Fields& fields) {
    const Number number = Number::from_raw(fields.integer(0, 2147483647));
    fields.expect_end();
    return number;
}

}  // namespace

std::string answer_project(Fields& fields, const Accuracy&) {
    const ModeAndView view = fields.mode();
    const auto point = convert<View>(fields.point());
    fields.expect_end();
    if (point.z <= View{}) return "behind";
    const ProbeProjection projection(view, y_up_basis(Angle{}, Angle{}, Angle{}));
    return format_position(position_of(point, to_far_view(point), projection));
}

std::string answer_view(Fields& fields, const Accuracy&) {
    constexpr int kDepthBits = 40;
    const ModeAndView view = fields.mode();
    const auto eye = convert<World>(fields.point());
    const Angle yaw = fields.angle(), pitch = fields.angle(), roll = fields.angle();
    const auto point = convert<World>(fields.point());
    fields.expect_end();

    const Basis axes = y_up_basis(yaw, pitch, roll);
    const FarPoint far_point = to_far_view(point, eye, y_up_fine_basis(yaw, pitch, roll));
    if (far_point.z.mantissa <= 0) return "behind";
    const ScreenPosition position = position_of(to_view(point, eye, axes), far_point, ProbeProjection(view, axes));
    return format_position(position) + ' ' + format_fixed(fixed_of(far_point.z, kDepthBits).value_or(0), kDepthBits);
}

FarProjection make_far_projection(const ScreenMode& mode, const SoftFloat& field_of_view_degrees) {
    const Ratio shape = mode.display * Ratio{mode.height_px, mode.width_px};
    FarProjection projection;
    projection.x = SoftFloat::from(mode.width_px, -1) * cotangent_of_half(field_of_view_degrees);
    projection.y = projection.x * whole(shape.numerator) / whole(shape.denominator);
    projection.centre_x = ScreenWide::from_raw(std::int64_t{mode.width_px} * 128);
    projection.centre_y = ScreenWide::from_raw(std::int64_t{mode.height_px} * 128);
    return projection;
}

std::string answer_sine(Fields& fields, const Accuracy& accuracy) {
    return format_fixed(sine(read_only_angle(fields), accuracy.sine));
}

std::string answer_cosine(Fields& fields, const Accuracy& accuracy) {
    return format_fixed(cosine(read_only_angle(fields), accuracy.sine));
}

std::string answer_root(Fields& fields, const Accuracy&) {
    return format_fixed(square_root<Root>(read_only_number(fields), Rounding::NearestHalfUp));
}

std::string answer_reciprocal(Fields& fields, const Accuracy&) {
    const Number number = read_only_number(fields);
    return number == Number{} ? "inf" : format_fixed(reciprocal<Reciprocal>(number));
}

}  // namespace oblong
