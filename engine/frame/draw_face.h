#pragma once

#include <cstdint>

#include "engine/frame/frame_context.h"
#include "engine/frame/workspace.h"

namespace oblong {

/// Draws what is still free of a face of the world: polygon, claim, surface, gradients, blocks, pixels. Sky is only
/// claimed, its spans left in work.sky_spans; liquids and sky that are not on the plan get one colour.
void draw_world_face(FaceIndex face_index, const FrameContext& frame, FrameWorkspace& work);

/// The same of the parts of brush models in a leaf.
void draw_fragments_in(LeafIndex leaf, const FrameContext& frame, FrameWorkspace& work);

}  // namespace oblong
