#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/geometry/projection.h"
#include "engine/geometry/texture_gradients.h"
#include "engine/geometry/view_context.h"
#include "engine/raster/texture_blocks.h"
#include "engine/scene/face_table.h"
#include "engine/surface/surface_cache.h"

namespace oblong {

/// Brightness of the 64 light styles, 256: as stored in the lightmaps.
using LightStyles = std::array<std::uint16_t, 64>;

/// All light styles at their stored brightness.
constexpr LightStyles plain_light_styles() {
    LightStyles styles{};
    for (std::uint16_t& style : styles) style = 256;
    return styles;
}

/// The texels that one face shows, and how they are drawn.
struct FaceSurface {
    SurfaceView view;
    int mip = 0;
    std::int32_t origin_u = 0, origin_v = 0;  ///< the texel of mip level 0 at its first column and row
    TexelLimits limits;
    BlockKernel kernel = nullptr;
};

/// The surfaces of a level's faces: a lit one from the cache or built now (texture times light), for a liquid the
/// texture itself, which wraps.
class FaceSurfaces {
  public:
    /// Level and table must outlive it. `longest_px`: of any span.
    FaceSurfaces(const Level& level, const FaceTable& faces, std::int32_t longest_px);

    /// The surface of a lit or liquid face whose nearest corner in view has this depth. Its texels are valid until the
    /// next call. All calls must pass the same colormap.
    FaceSurface get(FaceIndex face, View nearest_z, const ProjectionAxis& projection_x, const Colormap& colormap,
                    const LightStyles& styles);

    BlockKernel kernel = best_block_kernel();

  private:
    FaceSurface lit(FaceIndex face, int mip, const Colormap& colormap, const LightStyles& styles);
    FaceSurface tiled(const Face& face, int mip) const;

    const Level& level_;
    const FaceTable& faces_;
    std::int32_t longest_px_;
    SurfaceCache cache_;
    std::vector<std::int32_t> corner_shades_;  ///< scratch
};

/// The screen gradients of a face's surface (make_texture_gradients), with the face moved by `offset`.
TextureGradients make_face_gradients(const Level& level, const Face& face, const FaceSurface& surface,
                                     const Vec3<World>& offset, const ViewContext& view,
                                     const InverseProjection& inverse_projection);

}  // namespace oblong
