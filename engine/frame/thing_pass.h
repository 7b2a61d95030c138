#pragma once

namespace oblong {

struct FrameContext;
struct ViewScratch;
struct VisibleThing;

/// Finds the particles, sprites, shadows and meshes that are in view and not wholly hidden by the claimed faces.
void find_things(const FrameContext& frame, ViewScratch& scratch);

/// Draws a thing where nothing is nearer.
void draw_thing(const VisibleThing& thing, const FrameContext& frame, ViewScratch& scratch);

/// Darkens the floors under shadows.
void draw_shadows(const FrameContext& frame, ViewScratch& scratch);

}  // namespace oblong
