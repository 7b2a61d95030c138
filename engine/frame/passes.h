#pragma once

#include "engine/frame/plan.h"

namespace oblong {

struct FrameContext;
class FrameWorkspace;

/// Claims the pixels that are free, plans, and runs the plan. Returns it.
FramePlan draw_view(const FrameContext& frame, FrameWorkspace& work);

}  // namespace oblong
