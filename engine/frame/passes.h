#pragma once

#include "engine/frame/plan.h"

namespace oblong {

struct FrameContext;
class FrameWorkspace;

/// Counts and records spans of a face that are drawn without a surface.
void note_spans(const ClaimedFace& claimed, std::span<const Span> spans, Framebuffer out, FrameWorkspace& work);

/// Claims the pixels that are free, plans, and runs the plan. Returns it.
FramePlan draw_view(const FrameContext& frame, FrameWorkspace& work);

}  // namespace oblong
