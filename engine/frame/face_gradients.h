#pragma once

#include "engine/frame/face_surface.h"

namespace oblong {

/// The screen gradients of a face's surface (make_texture_gradients), with the face moved by `offset`.
TextureGradients make_face_gradients(const Face& face, const FaceSurface& surface, const Vec3<World>& offset,
                                     const FrameContext& frame);

}  // namespace oblong
