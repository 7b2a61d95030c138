#pragma once

#include "engine/view/texture_gradients.h"

namespace oblong {

struct FrameContext;
struct TornSpan;
struct ViewScratch;

/// Finds what is behind pixels that no face covers, in a frame from the open, with the tree, which is complete even if
/// faces are missing. If a ray through the pixel enters a solid leaf, the texture and the light of the nearest face are
/// continued on the node's plane where it enters (`claims.torn`). If it enters a sky leaf, the sky owns the pixel. If
/// it never leaves the open, the pixel is void, colour 0 (`claims.void_spans`).
void claim_torn_pixels(const FrameContext& frame, ViewScratch& scratch);

/// Draws these pixels with a division each, regardless of the dials, as they are few.
void draw_torn_pixels(const FrameContext& frame, ViewScratch& scratch);

/// 1/z of the wall shown by a torn span.
PlaneInverseZ inverse_z_of(const TornSpan& torn, const FrameContext& frame);

}  // namespace oblong
