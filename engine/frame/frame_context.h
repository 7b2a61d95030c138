#pragma once

#include "engine/frame/frame.h"
#include "engine/geometry/texture_gradients.h"
#include "engine/raster/texture_blocks.h"
#include "engine/visible/view_context.h"

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

}  // namespace oblong
