#pragma once

#include "engine/geometry/texture_gradients.h"
#include "engine/geometry/view_context.h"
#include "engine/scene/face_surface.h"

namespace oblong {

/// The screen gradients of a face's surface (make_texture_gradients), with the face moved by `offset`.
TextureGradients make_face_gradients(const Level& level, const Face& face, const FaceSurface& surface,
                                     const Vec3<World>& offset, const ViewContext& view,
                                     const InverseProjection& inverse_projection);

}  // namespace oblong
