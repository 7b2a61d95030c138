#pragma once

#include <span>

#include "engine/frame/claims.h"

namespace oblong {

/// Finds what stands behind pixels that no face covers, in a frame from the open: the tree knows where the open ends,
/// whether a face is there or not. A ray through the pixel enters a solid leaf through a node's plane: on that plane
/// the texture and the light of the nearest face go on (`claims.torn`). Where it enters a sky leaf, the sky owns the
/// pixel. What is left is the void, colour 0 (`claims.left_free`): rays that never leave the open.
void claim_torn_pixels(const FrameContext& frame, ViewScratch& scratch);

/// Draws them, with a division a pixel, whatever the dials say: these are few.
void draw_torn_pixels(const FrameContext& frame, ViewScratch& scratch);

/// 1/z of the wall that a torn span shows.
PlaneInverseZ inverse_z_of(const TornSpan& torn, const FrameContext& frame);

}  // namespace oblong
