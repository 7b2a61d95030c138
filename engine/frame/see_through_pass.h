#pragma once

namespace oblong {

struct FrameContext;
struct ViewScratch;

/// Draws what does not claim its pixels, far to near: faces that are seen through, in the walk's order turned round,
/// and things among them. A thing is drawn before the farthest of these faces that it is behind.
void draw_see_through(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
