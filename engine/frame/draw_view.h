#pragma once

#include "engine/frame/frame_plan.h"
#include "engine/level/level.h"

namespace oblong {

struct FrameContext;
struct ViewScratch;

/// Starts a view from a leaf: finds its visible set, and clears the claims. The caller then sets the span buffer's free
/// pixels: all, or a mirror's.
void start_view(const FrameContext& frame, LeafIndex leaf, ViewScratch& scratch);

/// Draws a started view: faces claim the free pixels of its span buffer, then the plan made from the claims is run.
/// Returns the plan.
FramePlan draw_view(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
