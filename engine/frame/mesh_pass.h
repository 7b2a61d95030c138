#pragma once

#include "engine/effects/sight.h"

namespace oblong {

struct FrameContext;
struct ViewScratch;

/// Finds the meshes that may be visible, and requests depth for them. Meshes are skipped if they are out of view, in no
/// leaf of the visible set, or hidden by nearer faces in their whole rectangle, and in a mirror's view if their origin
/// is behind it.
void find_meshes(const FrameContext& frame, const Sight& sight, ViewScratch& scratch);

/// Removes the meshes before the first one that faces do not wholly hide; all, if there is none. That decides whether
/// the pass runs; draw_meshes() tests the others. Requires depth.
void keep_seen_meshes(const FrameContext& frame, ViewScratch& scratch);

/// Draws the remaining meshes, in the level's light and fog.
void draw_meshes(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
