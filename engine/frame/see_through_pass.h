#pragma once

namespace oblong {

struct FrameContext;
struct ViewScratch;

/// Draws what does not claim pixels, back to front: see-through faces, in the reverse order of the walk, and things
/// among them. A thing is drawn before the farthest of these faces that is in front of it.
void draw_see_through(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
