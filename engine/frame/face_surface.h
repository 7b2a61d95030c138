#pragma once

#include <cstdint>

#include "engine/frame/frame_context.h"
#include "engine/frame/workspace.h"

namespace oblong {

/// The texels that one face shows, and how they are drawn.
struct FaceSurface {
    SurfaceView view;
    int mip = 0;
    std::int32_t origin_u = 0, origin_v = 0;  ///< the texel of mip level 0 that its first column and row are
    TexelLimits limits;
    BlockKernel kernel = nullptr;
};

/// The surface of a lit or liquid face whose nearest corner in view has this depth: a lit one from the cache or built
/// now, for a liquid the texture itself, which wraps.
FaceSurface choose_face_surface(FaceIndex face_index, std::int64_t nearest_z_16, const FrameContext& frame,
                                FrameWorkspace& work);

}  // namespace oblong
