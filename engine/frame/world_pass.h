#pragma once

#include "engine/frame/frame_context.h"
#include "engine/frame/workspace.h"

namespace oblong {

/// Draws the world and its brush models front to back, each pixel once. Sky is only claimed: its spans are left in
/// work.sky_spans. From the open nothing is left free.
void draw_world(const FrameContext& frame, FrameWorkspace& work);

}  // namespace oblong
