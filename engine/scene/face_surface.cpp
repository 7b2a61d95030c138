#include "engine/scene/face_surface.h"

#include <algorithm>
#include <bit>

#include "engine/base/range_probe.h"
#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/level/side.h"
#include "engine/surface/coloured_surface.h"

namespace oblong {

namespace {

/// The surface cache of a mode. A 320x200 frame needs 0.3 to 0.6 MB. With three times that, turning round in a room
/// sometimes builds its surfaces again, which takes up to a twentieth of the time. In large modes surfaces use their
/// finest mip levels and need fewer bytes a pixel.
SurfaceCache surface_cache(const Level& level, const ScreenMode& mode) {
#ifdef OBLONG_SMALL_MEMORY
    constexpr std::size_t kBytesAPixel = 4, kLeast = std::size_t{1} << 18, kPiece = std::size_t{1} << 16;
#else
    constexpr std::size_t kBytesAPixel = 28, kLeast = std::size_t{1} << 20, kPiece = std::size_t{12} << 20;
#endif
    constexpr std::size_t kMost = std::size_t{12} << 20;
    const std::size_t bytes = std::clamp(kBytesAPixel * pixel_count(mode.width_px, mode.height_px), kLeast, kMost);
    return {level.faces.size() * 4, bytes, std::min(bytes, kPiece)};
}

std::int32_t floor_to_multiple(std::int32_t value, std::int32_t size) {
    const std::int32_t rest = value % size;
    return value - (rest < 0 ? rest + size : rest);
}

/// A whole texture as a tile. Its masks wrap it if its sizes are powers of two.
SurfaceView tile_of(const MipTexture& texture, int mip) {
    SurfaceView tile;
    tile.texels = item(texture.mips, mip).data();
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

SurfaceView shape_of(const Face& face, int mip) {
    SurfaceView surface;
    surface.width = std::max(lit_size(face.sample_columns(), mip), 1);
    surface.height = std::max(lit_size(face.sample_rows(), mip), 1);
    const std::uint32_t stride = std::bit_ceil(static_cast<std::uint32_t>(surface.width));
    surface.stride_log2 = std::countr_zero(stride);
    surface.u_mask = stride - 1;
    surface.v_mask = std::bit_ceil(static_cast<std::uint32_t>(surface.height)) - 1;
    surface.holds_blocks = true;
    return surface;
}

LightmapView light_of(const Level& level, const Face& face, const LightStyles& styles) {
    LightmapView light;
    light.columns = face.sample_columns();
    light.rows = face.sample_rows();
    light.has_no_lightmaps = level.lighting.empty();
    if (face.light_offset < 0 || light.has_no_lightmaps) return light;
    light.samples = level.lighting.data() + face.light_offset;
    for (const std::uint8_t style : face.used_styles())
        item(light.style_scale_256, light.style_count++) = styles[style % styles.size()];
    return light;
}

TextureIndex texture_of(const Level& level, const Face& face, const SurfaceState& state) {
    return state.texture.is_none() ? level.texinfos[face.texinfo].texture : state.texture;
}

std::uint64_t key_of(const LightmapView& light) {
    std::uint64_t key = 0;
    for (const std::uint16_t scale : light.style_scale_256) key = key << 16 | scale;
    return key;
}

std::size_t light_sample_count(const Face& face) {
    return as_size(face.sample_columns() * face.sample_rows());
}

std::size_t most_light_samples(const Level& level, const FaceTable& table) {
    std::size_t most = 0;
    for (const FaceIndex face : level.faces.indices())
        if (table[face].material == Material::Lit) most = std::max(most, light_sample_count(level.faces[face]));
    return most;
}

/// Texture coordinates of the eye, from the world's origin.
Texel eye_texel(const Vec3<TexelAxis>& axis, Texel offset, const Vec3<World>& eye) {
    const auto along = dot(axis, eye);
    note_range<"texture axis . eye">(along);
    const Texel texel = convert<Texel>(along) + offset;
    note_range<"texel of the eye">(texel);
    return texel;
}

/// For faces edge-on or turned round by rounding to the screen: for such slivers any small distance will do.
constexpr auto kLeastDistance = PlaneDistance::from_raw(std::int64_t{1} << 30);

/// The normal of a face's plane, on the side that the face faces.
Vec3<Unit> normal_of(const LevelPlane& plane, bool is_back) {
    return is_back ? -plane.normal : plane.normal;
}

}  // namespace

FaceSurfaces::FaceSurfaces(const Level& level, const FaceTable& faces, const ScreenMode& mode)
    : level_(level),
      faces_(faces),
      longest_px_(mode.width_px),
      cache_(surface_cache(level, mode)),
      moving_lights_(level, faces),
      corners_(most_light_samples(level, faces) * (level.coloured_lighting.empty() ? 1 : 3)) {}

void FaceSurfaces::start_frame(const Accuracy& accuracy, std::int32_t brightness_100, const Colormap& colormap,
                               const Kernels& kernels) {
    kernels_ = &kernels;
    cache_.start_frame();
    const LightQuality quality{accuracy.light, accuracy.shades, accuracy.dithers_light, brightness_100,
                               accuracy.colour_levels};
    if (colormap_ == &colormap && light_quality_ == quality) return;
    cache_.clear();
    if (colormap_ != &colormap) cubes_.clear();
    light_quality_ = quality;
    colormap_ = &colormap;
    fewer_shades_.reset();
    if (quality.shades < Colormap::kShades) fewer_shades_ = with_shades(colormap, quality.shades);
    cube_ = quality.colour_levels > 0 && !level_.coloured_lighting.empty() ? cube_of(quality.colour_levels) : nullptr;
    build_surface_ = cube_ ? build_coloured_surface : build_lit_surface;
}

const ColourCube* FaceSurfaces::cube_of(std::int32_t levels) {
    const auto known = cubes_.find(levels);
    if (known != cubes_.end()) return &known->second;
    return &cubes_.emplace(levels, make_colour_cube(colormap_->palette, levels)).first->second;
}

/// Mip levels 0, 1 and 2 end where the nearest texels are 1, 0.4 and 0.2 pixels wide: Quake's thresholds.
int FaceSurfaces::mip_level(FaceIndex face, View nearest_z, const ProjectionAxis& projection_x,
                            std::int32_t bias) const {
    const CoarseMultiplier multiplier = floor_shift(projection_x.coarse, std::max(bias, 0));
    const auto density_times_z =
        floor_shift(product<CoarseMultiplier>(nearest_z, convert<TexelDensity>(faces_[face].density), Rounding::Floor),
                    std::max(-bias, 0));
    note_range<"texels per pixel, doubled">(density_times_z * 2);
    return (density_times_z > multiplier) + (density_times_z * 2 > multiplier * 5) + (density_times_z > multiplier * 5);
}

FaceSurface FaceSurfaces::get(FaceIndex face, int mip, const SurfaceState& state) {
    if (faces_[face].material == Material::Lit) return lit(face, mip, state);
    return tiled(level_.faces[face], mip, level_.textures[texture_of(level_, level_.faces[face], state)]);
}

FaceSurface FaceSurfaces::lit(FaceIndex index, int mip, const SurfaceState& state) {
    const Face& face = level_.faces[index];
    // In place: a copy of what was just written waits for the writes.
    FaceSurface surface{shape_of(face, mip),
                        mip,
                        face.texel_min_u,
                        face.texel_min_v,
                        make_texel_limits(std::max(face.texel_extent_u >> mip, 1),
                                          std::max(face.texel_extent_v >> mip, 1), longest_px_),
                        kernels_->draw_blocks};

    LightmapView light = light_of(level_, face, state.styles);
    const bool may_be_touched = !moving_lights_.is_empty() && !light.has_no_lightmaps;
    const LightTouch touch = may_be_touched ? moving_lights_.touch(index, state.offset) : LightTouch{};
    const std::size_t bytes = as_size(surface.view.height) << surface.view.stride_log2;
    const SurfaceCache::Found found =
        cache_.get(index.position() * 4 + as_size(mip), bytes, {key_of(light), state.texture.number(), touch.version});
    surface.view.texels = found.texels;
    if (found.is_valid) return surface;
    light.added_8 = moving_light(index, touch, state.offset);
    build(index, surface, texture_of(level_, face, state), light, found.texels);
    return surface;
}

const std::int32_t* FaceSurfaces::moving_light(FaceIndex index, const LightTouch& touch, const Vec3<World>& offset) {
    if (touch.lights == 0) return nullptr;
    moving_light_8_.assign(light_sample_count(level_.faces[index]), 0);
    moving_lights_.add_light(index, offset, touch.lights, moving_light_8_);
    return moving_light_8_.data();
}

void FaceSurfaces::build(FaceIndex index, const FaceSurface& surface, TextureIndex texture_index,
                         const LightmapView& light, std::uint8_t* texels) {
    const Face& face = level_.faces[index];
    const MipTexture& texture = level_.textures[texture_index];
    const int mip = surface.mip;
    const TextureView source{item(texture.mips, mip).data(), texture.width >> mip, texture.height >> mip,
                             floor_shift(face.texel_min_u, mip), floor_shift(face.texel_min_v, mip)};
    const LightTables tables{
        colormap(), kernels_->light_cells, colour_cube(), {level_.lighting.data(), level_.coloured_lighting.data()}};
    build_surface_(source, light, tables, light_quality_, mip, 1 << surface.view.stride_log2, corners_.data(), texels);
    built_texels_ += std::int64_t{surface.view.width} * surface.view.height;
    ++built_surfaces_;
}

FaceSurface FaceSurfaces::tiled(const Face& face, int mip, const MipTexture& texture) const {
    constexpr std::int32_t kMostTexels = 65535;
    FaceSurface surface;
    surface.view = tile_of(texture, mip);
    surface.mip = mip;
    surface.origin_u = floor_to_multiple(face.texel_min_u, texture.width);
    surface.origin_v = floor_to_multiple(face.texel_min_v, texture.height);
    surface.limits = make_texel_limits(kMostTexels, kMostTexels, longest_px_);
    surface.is_wrapped_by_masks = is_wrapped_by_masks(surface.view);
    surface.kernel = surface.is_wrapped_by_masks ? kernels_->draw_blocks : draw_blocks_any_size;
    return surface;
}

PlaneInverseZ make_face_inverse_z(const Level& level, const Face& face, const Vec3<World>& offset,
                                  const ViewContext& view, const InverseProjection& inverse_projection) {
    if (view.is_parallel()) return {{reciprocal<InverseZ>(view.parallel_depth), {}, {}}, {}};
    const LevelPlane& plane = level.planes[face.plane];
    const PlaneDistance distance = distance_before(plane, face.is_back, view.eye - offset);
    return make_inverse_z(normal_of(plane, face.is_back), std::max(distance, kLeastDistance), view.rays,
                          inverse_projection);
}

TextureGradients make_face_gradients(const Level& level, const Face& face, const FaceSurface& surface,
                                     const Vec3<World>& offset, const PlaneInverseZ& inverse_z, const ViewContext& view,
                                     const InverseProjection& inverse_projection) {
    const TexInfo& texinfo = level.texinfos[face.texinfo];
    const Vec3<World> eye = view.eye - offset;
    const TextureAxes axes{
        texinfo.s, texinfo.t, eye_texel(texinfo.s, texinfo.s_offset, eye) - Texel::from_int(surface.origin_u),
        eye_texel(texinfo.t, texinfo.t_offset, eye) - Texel::from_int(surface.origin_v), surface.mip};
    if (!view.is_parallel()) return make_texture_gradients(axes, inverse_z, view.rays, inverse_projection);
    const LevelPlane& plane = level.planes[face.plane];
    return make_parallel_gradients(axes, normal_of(plane, face.is_back), distance_before(plane, face.is_back, eye),
                                   inverse_z.origin, view.rays, inverse_projection);
}

}  // namespace oblong
