#include "engine/frame/face_surface.h"

#include <algorithm>
#include <bit>

#include "engine/base/range_probe.h"
#include "engine/fixed/wide.h"

namespace oblong {

namespace {

/// The mip level for a polygon whose nearest texels are 1, 0.4 and 0.2 pixels wide at the ends of levels 0, 1 and 2:
/// Quake's thresholds.
int mip_level(std::int64_t nearest_z_16, std::int64_t density_16, const ProjectionAxis& axis) {
    const std::int64_t texels_per_pixel_times_multiplier_16 = mul_shift(nearest_z_16, density_16, 16, Rounding::Floor);
    const std::int64_t multiplier_16 = axis.coarse_16;
    note_range<Quantity::MipProduct>(texels_per_pixel_times_multiplier_16);
    return (texels_per_pixel_times_multiplier_16 > multiplier_16) +
           (texels_per_pixel_times_multiplier_16 * 2 > multiplier_16 * 5) +
           (texels_per_pixel_times_multiplier_16 > multiplier_16 * 5);
}

std::int32_t floor_to_multiple(std::int32_t value, std::int32_t size) {
    const std::int32_t rest = value % size;
    return value - (rest < 0 ? rest + size : rest);
}

/// A whole texture as a tile. Its masks wrap it if its sizes are powers of two.
SurfaceView tile_of(const MipTexture& texture, int mip) {
    SurfaceView tile;
    tile.texels = texture.mips[static_cast<std::size_t>(mip)].data();
    tile.width = texture.width >> mip;
    tile.height = texture.height >> mip;
    tile.stride_log2 = static_cast<int>(std::bit_width(static_cast<std::uint32_t>(tile.width))) - 1;
    tile.u_mask = static_cast<std::uint32_t>(tile.width) - 1;
    tile.v_mask = static_cast<std::uint32_t>(tile.height) - 1;
    return tile;
}

bool is_wrapped_by_masks(const SurfaceView& tile) {
    return std::has_single_bit(static_cast<std::uint32_t>(tile.width)) &&
           std::has_single_bit(static_cast<std::uint32_t>(tile.height));
}

FaceSurface lit_surface(FaceIndex face_index, int mip, const FrameContext& frame, FrameWorkspace& work) {
    const Face& face = frame.scene.level.faces[face_index];
    FaceSurface surface;
    surface.view = lit_surface_of(frame.scene.level, face_index, mip, frame.scene.colormap, frame.scene.light_styles,
                                  work.surfaces, work.corner_shades);
    surface.mip = mip;
    surface.origin_u = face.texel_min_u;
    surface.origin_v = face.texel_min_v;
    surface.limits = make_texel_limits(std::max(face.texel_extent_u >> mip, 1), std::max(face.texel_extent_v >> mip, 1),
                                       frame.view.projection.width_px);
    surface.kernel = work.kernel;
    return surface;
}

FaceSurface tiled_surface(const Face& face, const MipTexture& texture, int mip, const FrameContext& frame,
                          const FrameWorkspace& work) {
    constexpr std::int32_t kMostTexels = 65535;
    FaceSurface surface;
    surface.view = tile_of(texture, mip);
    surface.mip = mip;
    surface.origin_u = floor_to_multiple(face.texel_min_u, texture.width);
    surface.origin_v = floor_to_multiple(face.texel_min_v, texture.height);
    surface.limits = make_texel_limits(kMostTexels, kMostTexels, frame.view.projection.width_px);
    surface.kernel = is_wrapped_by_masks(surface.view) ? work.kernel : draw_blocks_any_size;
    return surface;
}

}  // namespace

FaceSurface choose_face_surface(FaceIndex face_index, std::int64_t nearest_z_16, const FrameContext& frame,
                                FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    const Face& face = level.faces[face_index];
    const PreparedFace& prepared = work.faces.faces[face_index];
    const int mip = mip_level(nearest_z_16, prepared.density_16, frame.view.projection.x);
    if (prepared.kind == FaceKind::Lit) return lit_surface(face_index, mip, frame, work);
    return tiled_surface(face, level.texture_of(face), mip, frame, work);
}

}  // namespace oblong
