#pragma once

#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/geometry/texture_gradients.h"

namespace oblong {

/// All that stays the same while the faces of one frame are drawn.
struct FrameContext {
    const Scene& scene;
    const Settings& settings;
    ViewContext view;
    GradientLens gradient_lens;
    BlockRule block_rule;
    FramePlan plan;
    Framebuffer out;
};

/// Draws the world and its brush models front to back, each pixel once. Sky is only claimed: its spans are left in
/// work.sky_spans. What is left free at the end is a hole.
void draw_world(const FrameContext& frame, FrameWorkspace& work);

}  // namespace oblong
