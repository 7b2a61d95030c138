#pragma once

#include "engine/frame/claims.h"
#include "engine/geometry/texture_gradients.h"
#include "engine/scene/face_surface.h"

namespace oblong {

/// Draws the faces of a list with their surfaces: texture, light, mip levels.
void draw_surfaces(FaceList list, const FrameContext& frame, FrameWorkspace& work);

/// The gradients of 1/z, u/z and v/z of a face with this surface, in as many bits as the settings keep.
TextureGradients gradients_of(const VisibleFace& visible, const FaceSurface& surface, const FrameContext& frame,
                              const FrameWorkspace& work);

}  // namespace oblong
