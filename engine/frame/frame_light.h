#pragma once

namespace oblong {

struct FrameContext;
struct ViewScratch;

/// Finds the brightness of the light styles, and the moving lights; if these touch no claimed face, none are kept.
/// Surfaces with changed light are built again when drawn.
void find_light(const FrameContext& frame, ViewScratch& scratch);

/// The same before faces have claimed their pixels. False, and nothing is done, if that is too early because lights may
/// move.
bool find_light_beforehand(const FrameContext& frame, ViewScratch& scratch);

/// Restores this view's lights, found by find_light(), after another view was drawn.
void restore_light(const FrameContext& frame, const ViewScratch& scratch);

}  // namespace oblong
