#include "engine/scene/lit_faces.h"

#include <algorithm>
#include <bit>

namespace oblong {

namespace {

std::int32_t columns_of(const Face& face) {
    return face.texel_extent_u / 16 + 1;
}
std::int32_t rows_of(const Face& face) {
    return face.texel_extent_v / 16 + 1;
}

SurfaceView shape_of(const Face& face, int mip) {
    SurfaceView surface;
    surface.width = std::max(lit_size(columns_of(face), mip), 1);
    surface.height = std::max(lit_size(rows_of(face), mip), 1);
    const std::uint32_t stride = std::bit_ceil(static_cast<std::uint32_t>(surface.width));
    surface.stride_log2 = std::countr_zero(stride);
    surface.u_mask = stride - 1;
    surface.v_mask = std::bit_ceil(static_cast<std::uint32_t>(surface.height)) - 1;
    return surface;
}

LightmapView light_of(const Level& level, const Face& face, const LightStyles& styles) {
    LightmapView light;
    light.columns = columns_of(face);
    light.rows = rows_of(face);
    light.is_fullbright = level.lighting.empty();
    if (face.light_offset < 0 || light.is_fullbright) return light;
    light.samples = level.lighting.data() + face.light_offset;
    for (const std::uint8_t style : face.styles) {
        if (style == 255) break;
        light.style_scale_256[static_cast<std::size_t>(light.style_count++)] = styles[style % styles.size()];
    }
    return light;
}

std::uint64_t key_of(const LightmapView& light) {
    std::uint64_t key = 0;
    for (const std::uint16_t scale : light.style_scale_256) key = key << 16 | scale;
    return key;
}

}  // namespace

std::size_t light_sample_count(const Face& face) {
    return static_cast<std::size_t>(columns_of(face) * rows_of(face));
}

std::size_t surface_bytes(const Face& face, int mip) {
    const SurfaceView surface = shape_of(face, mip);
    return static_cast<std::size_t>(surface.height) << surface.stride_log2;
}

SurfaceView lit_surface_of(const Level& level, FaceIndex index, int mip, const Colormap& colormap,
                           const LightStyles& styles, SurfaceCache& cache, std::vector<std::int32_t>& corner_shades) {
    const Face& face = level.faces[index];
    SurfaceView surface = shape_of(face, mip);
    const LightmapView light = light_of(level, face, styles);
    const SurfaceCache::Found found =
        cache.get(index.position() * 4 + static_cast<std::size_t>(mip), surface_bytes(face, mip), key_of(light));
    surface.texels = found.texels;
    if (found.is_valid) return surface;

    const MipTexture& texture = level.texture_of(face);
    const TextureView source{texture.mips[static_cast<std::size_t>(mip)].data(), texture.width >> mip,
                             texture.height >> mip, floor_shift(face.texel_min_u, mip),
                             floor_shift(face.texel_min_v, mip)};
    build_lit_surface(source, light, colormap, mip, 1 << surface.stride_log2, corner_shades.data(), found.texels);
    return surface;
}

}  // namespace oblong
