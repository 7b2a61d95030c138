#pragma once

namespace oblong {

struct FrameContext;
class FrameWorkspace;

/// Finds how bright the light styles of the claimed faces are, and which moving lights touch them: none are kept if
/// they touch no face. What these change is built again when it is drawn.
void find_light(const FrameContext& frame, FrameWorkspace& work);

/// The same before any face has claimed its pixels, if that makes no difference: where no lights move. Else false.
bool find_light_beforehand(const FrameContext& frame, FrameWorkspace& work);

}  // namespace oblong
