#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "engine/raster/texture_blocks.h"
#include "engine/scene/face_table.h"
#include "engine/scene/light_styles.h"
#include "engine/scene/moving_lights.h"
#include "engine/surface/lit_surface.h"
#include "engine/surface/surface_cache.h"
#include "engine/view/projection.h"
#include "engine/view/texture_gradients.h"
#include "engine/view/view_context.h"

namespace oblong {

/// What a face's texels depend on besides its mip level.
struct SurfaceState {
    const LightStyles& styles;
    TextureIndex texture = TextureIndex::none();  ///< the frame of an animated texture; none: the face's own
    Vec3<World> offset{};                         ///< of the face's model
};

/// The texels of one face, and how they are drawn.
struct FaceSurface {
    SurfaceView view;
    int mip = 0;
    std::int32_t origin_u = 0, origin_v = 0;  ///< the texel of mip level 0 at the first column and row
    TexelLimits limits;
    BlockKernel kernel = nullptr;
    bool is_wrapped_by_masks = true;
};

/// The surfaces of a level's faces. Lit surfaces (texture times light) come from the cache or are built; a liquid's
/// surface is the texture itself, which wraps.
class FaceSurfaces {
  public:
    /// `level` and `faces` must outlive it.
    FaceSurfaces(const Level& level, const FaceTable& faces, const ScreenMode& mode);

    /// Sets how light is computed and surfaces are drawn from now on. Texels returned earlier may be overwritten from
    /// now on.
    void start_frame(const Accuracy& accuracy, std::int32_t brightness_100, const Colormap& colormap,
                     const Kernels& kernels);
    /// The colormap used for light: the scene's, or a copy with fewer shades.
    const Colormap& colormap() const { return fewer_shades_ ? *fewer_shades_ : *colormap_; }
    /// Of coloured light; null: all light is white, or drawn so.
    const ColourCube* colour_cube() const { return cube_; }
    /// The mip level of a lit or liquid face, or a part of one, whose nearest point in view has the depth `nearest_z`.
    int mip_level(FaceIndex face, View nearest_z, const ProjectionAxis& projection_x, std::int32_t bias) const;
    /// Sets the moving lights from now on; at first there are none.
    void set_moving_lights(std::span<const MovingLight> lights, const Vec3<World>& eye) {
        if (!lights.empty() || has_moving_lights()) moving_lights_.set(lights, eye);
    }
    bool has_moving_lights() const { return !moving_lights_.is_empty(); }
    /// Whether a moving light touches a lit face, its model moved by `offset`.
    bool is_touched(FaceIndex face, const Vec3<World>& offset) {
        return faces_[face].material == Material::Lit && moving_lights_.touch(face, offset).lights != 0;
    }
    /// The surface of a lit or liquid face. Its texels stay where they are, unchanged, until the next start_frame().
    FaceSurface get(FaceIndex face, int mip, const SurfaceState& state);
    /// Drops all lit surfaces; the next frame builds them again.
    void clear() { cache_.clear(); }
    std::int64_t built_texels() const { return built_texels_; }      ///< in all lit surfaces ever built
    std::int64_t built_surfaces() const { return built_surfaces_; }  ///< number of lit surfaces ever built
    const SurfaceCache& cache() const { return cache_; }

  private:
    const ColourCube* cube_of(std::int32_t levels);
    FaceSurface lit(FaceIndex face, int mip, const SurfaceState& state);
    FaceSurface tiled(const Face& face, int mip, const MipTexture& texture) const;
    void build(FaceIndex face, const FaceSurface& surface, TextureIndex texture, const LightmapView& light,
               std::uint8_t* texels);
    /// The moving light on a face's samples; null: none.
    const std::int32_t* moving_light(FaceIndex face, const LightTouch& touch, const Vec3<World>& offset);

    const Level& level_;
    const FaceTable& faces_;
    std::int32_t longest_px_;
    SurfaceCache cache_;
    MovingLights moving_lights_;
    const Kernels* kernels_ = nullptr;
    LightQuality light_quality_;                ///< of the surfaces in the cache
    const Colormap* colormap_ = nullptr;        ///< the scene's
    std::optional<Colormap> fewer_shades_;      ///< used instead of `colormap_`
    std::map<std::int32_t, ColourCube> cubes_;  ///< by their levels, as it takes long to make one
    const ColourCube* cube_ = nullptr;
    decltype(&build_lit_surface) build_surface_ = build_lit_surface;
    std::vector<std::int32_t> corners_;         ///< scratch
    std::vector<std::int32_t> moving_light_8_;  ///< scratch, allocated when a light first touches a face
    std::int64_t built_texels_ = 0, built_surfaces_ = 0;
};

/// 1/z of a face over the screen, its model moved by `offset`.
PlaneInverseZ make_face_inverse_z(const Level& level, const Face& face, const Vec3<World>& offset,
                                  const ViewContext& view, const InverseProjection& inverse_projection);

/// Screen gradients of a face's texture coordinates; `inverse_z` is from make_face_inverse_z().
TextureGradients make_face_gradients(const Level& level, const Face& face, const FaceSurface& surface,
                                     const Vec3<World>& offset, const PlaneInverseZ& inverse_z, const ViewContext& view,
                                     const InverseProjection& inverse_projection);

}  // namespace oblong
