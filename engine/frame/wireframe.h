#pragma once

#include <span>

#include "engine/frame/frame.h"
#include "engine/raster/lines.h"

namespace oblong {

/// Draws the edges of all faces that own pixels in the last frame of `work`, which must have this level, view and mode.
/// Edges are clipped in viewspace, so they may end behind the eye.
void draw_wireframe(const Level& level, const ViewSpec& view, const ScreenMode& mode, const Settings& settings,
                    const FrameWorkspace& work, const LineStyle& style, Framebuffer out);

/// Draws lines from each point to the next, also where something is in front of them: six, 4 units from the path along
/// the axes, as one line alone is a dot for an eye that looks along it.
void draw_path(std::span<const Vec3<World>> points, const ViewSpec& view, const ScreenMode& mode,
               const Settings& settings, const LineStyle& style, Framebuffer out);

}  // namespace oblong
