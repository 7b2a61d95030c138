#pragma once

#include "engine/effects/things_in_view.h"

namespace oblong {

struct FrameContext;
struct ViewScratch;

/// Finds the meshes that may be seen, and wants depth where they are. Those out of view, in no leaf of the visible set,
/// or whose whole rectangle faces nearer than their box cover, are not looked at further; nor are those behind a
/// mirror, by their place, in its picture.
void find_meshes(const FrameContext& frame, const Sight& sight, ViewScratch& scratch);

/// Leaves out those before the first one of which faces leave a pixel: all of them, if they hide all. Depth is there.
void keep_seen_meshes(const FrameContext& frame, ViewScratch& scratch);

/// Draws the meshes that are left, in the level's light and fog.
void draw_meshes(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
