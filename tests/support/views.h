#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "engine/view/view_context.h"
#include "tests/support/point.h"

/// Views of 320x200 pixels on 4:3, 90 degrees across: of the engine, and in doubles.
namespace oblong::test {

/// At no angle: x of the world is ahead, -y right, z up.
inline ViewContext view_along(const Vec3<World>& eye, const Basis& axes, ScreenMode mode = {}, int degrees = 90) {
    ViewContext view;
    view.eye = eye;
    view.axes = axes;
    view.viewpoint = {view.eye};
    view.rays = view.axes;
    view.projection = make_projection(mode, Degrees::from_int(degrees));
    view.frustum = make_frustum(view.axes, view.projection);
    view.grid = SubpixelGrid::of_bits(8);
    return view;
}
inline ViewContext view_from(const Vec3<World>& eye, Angle yaw = {}, Angle pitch = {}, ScreenMode mode = {}) {
    return view_along(eye, view_basis(yaw, pitch, {}), mode);
}
/// Degrees; pitch positive looks down.
inline Camera camera_at(const Vec3<World>& eye, double yaw, double pitch = 0) {
    const auto angle = [](double degrees) { return Angle::from_bam(std::llround(degrees / 360 * 65536)); };
    return {eye, angle(yaw), angle(pitch), {}};
}
/// Each row of 320x200 pixels.
inline std::vector<Span> all_rows() {
    std::vector<Span> spans;
    for (std::int32_t y = 0; y < 200; ++y) spans.push_back({y, 0, 320});
    return spans;
}

inline double radians_of(Angle angle) {
    return angle.bam * std::numbers::pi / 32768;
}

/// A camera without roll in doubles, and the rays through its screen: 1 along `ahead`.
struct TrueCamera {
    static constexpr double kAcross = 160, kDown = 160 / 1.2;  ///< pixels at a depth of 1
    Point eye, ahead, right, up;

    explicit TrueCamera(const Camera& camera) : eye(to_point(camera.eye)) {
        const double yaw = radians_of(camera.yaw), pitch = radians_of(camera.pitch);
        ahead = {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), -std::sin(pitch)};
        right = {std::sin(yaw), -std::cos(yaw), 0};
        up = cross(right, ahead);
    }
    Point through(double column, double row) const {
        return ahead + right * ((column - 160) / kAcross) + up * ((100 - row) / kDown);
    }
    Point through_pixel(int column, int row) const { return through(column + 0.5, row + 0.5); }
    /// Column, row and depth of a point.
    Point shown(const Point& p) const {
        const Point way = p - eye;
        const double depth = dot(way, ahead);
        return {160 + kAcross * dot(way, right) / depth, 100 - kDown * dot(way, up) / depth, depth};
    }
};

/// What is found along the rays through a pixel's centre and those `margin` pixels beside it; none where they differ.
auto at_all_rays(const auto& camera, int column, int row, double margin, auto of_ray) {
    const auto middle = of_ray(camera.through(column + 0.5, row + 0.5));
    std::optional found(middle);
    for (const double dx : {-margin, margin})
        for (const double dy : {-margin, margin})
            if (found && of_ray(camera.through(column + 0.5 + dx, row + 0.5 + dy)) != middle) found.reset();
    return found;
}

}  // namespace oblong::test
