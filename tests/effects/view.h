#pragma once

#include "engine/view/view_context.h"

namespace oblong::test {

/// A view at 320x200 from `eye`, at 90 degrees across. At no angle: x of the world is ahead, -y right, z up.
inline ViewContext view_from(const Vec3<World>& eye, Angle yaw = {}, Angle pitch = {}, ScreenMode mode = {}) {
    ViewContext view;
    view.eye = eye;
    view.axes = view_basis(yaw, pitch, {});
    view.viewpoint = {view.eye};
    view.rays = view.axes;
    view.projection = make_projection(mode, Degrees::from_int(90));
    view.frustum = make_frustum(view.axes, view.projection);
    view.grid = SubpixelGrid::of_bits(8);
    return view;
}

inline Vec3<World> at_units(std::int32_t x, std::int32_t y, std::int32_t z) {
    return {World::from_int(x), World::from_int(y), World::from_int(z)};
}

}  // namespace oblong::test
