#include "tools/reference/view.h"

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

}  // namespace

Camera make_camera(const View& view) {
    Projection projection = make_projection(view.width_px, view.height_px, view.display, view.field_of_view);
    if (!view.correct_aspect) projection.multiplier_y = projection.multiplier_x;
    return {view.eye, make_world_axes(view), projection};
}

}  // namespace oblong::reference
