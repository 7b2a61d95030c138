#include "engine/view/frustum.h"
#include "tools/probe/decimal.h"
#include "tools/probe/project_far.h"
#include "tools/probe/queries.h"

namespace oblong {

namespace {

/// The projection of a frame, and the same with more bits for what no frame projects.
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

}  // namespace

std::string answer_project(Fields& fields) {
    const ModeAndView view = fields.mode();
    const auto point = convert<View>(fields.point());
    fields.expect_end();
    if (point.z <= View{}) return "behind";
    const ProbeProjection projection(view, y_up_basis(Angle{}, Angle{}, Angle{}));
    return format_position(position_of(point, to_far_view(point), projection));
}

std::string answer_view(Fields& fields) {
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

}  // namespace oblong
