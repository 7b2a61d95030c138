#pragma once

#include "engine/view/view_spec.h"
#include "tools/gallery/row.h"

namespace oblong {

/// A camera in the demo level: whole world units, whole degrees (pitch positive looks down).
Camera camera_at(std::int32_t x, std::int32_t y, std::int32_t z, int yaw, int pitch, int field_of_view = 90);

/// Draws the demo level in a view as it stands at the input's time, into a canvas of the input's mode.
void draw_demo_level(const RowInput& input, const ViewSpec& view, Framebuffer canvas);

/// Draws the demo level as it stands at the input's time, into a canvas of the mode's size.
void draw_demo_level(const RowInput& input, const Camera& camera, const ScreenMode& mode, Framebuffer canvas);

}  // namespace oblong
