#pragma once

#include "engine/frame/frame.h"
#include "engine/geometry/texture_gradients.h"
#include "engine/geometry/view_context.h"
#include "engine/raster/texture_blocks.h"

namespace oblong {

/// All that stays the same while the faces of one frame are drawn.
struct FrameContext {
    const Scene& scene;
    const Settings& settings;
    ViewContext view;
    InverseProjection inverse_projection;
    BlockRule block_rule;
    FramePlan plan;
    Framebuffer out;
};

}  // namespace oblong
