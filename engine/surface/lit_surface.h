#pragma once

#include <array>
#include <cstdint>

#include "engine/accuracy/accuracy.h"
#include "engine/surface/colormap.h"

namespace oblong {

/// Texels to draw; rows are `1 << stride_log2` bytes apart. Coordinates wrap at the masks, powers of two minus one:
/// textures repeat; lit surfaces are never sampled beyond their size.
struct SurfaceView {
    const std::uint8_t* texels = nullptr;
    std::int32_t width = 0, height = 0;
    std::int32_t stride_log2 = 0;
    std::uint32_t u_mask = 0, v_mask = 0;
    bool holds_blocks = false;  ///< blocks cut to its TexelLimits stay within it, so that kernels need not wrap
};

/// A face's lightmap: `columns` x `rows` samples for each style in use, one every 16 texels of mip level 0.
struct LightmapView {
    const std::uint8_t* samples = nullptr;  ///< style after style; unused without styles
    std::int32_t columns = 0, rows = 0;
    std::int32_t style_count = 0;
    std::array<std::uint16_t, 4> style_scale_256{};  ///< brightness of each style, 256: as stored
    const std::int32_t* added_8 = nullptr;           ///< light added to each sample, 8 fraction bits; null: none
    bool has_no_lightmaps = false;  ///< no lightmaps in the level; otherwise a face without styles is black
};

/// One mip level of a texture, and where a face's surface begins in it. All sizes and positions are multiples of 16 at
/// mip level 0, and of a cell between light samples at each mip level.
struct TextureView {
    const std::uint8_t* texels = nullptr;
    std::int32_t width = 0, height = 0;  ///< of this mip level
    std::int32_t min_u = 0, min_v = 0;   ///< of the surface, in this mip level's texels; any sign
};

/// The lightmap value that shows a texture's colours unchanged, the middle of the range, as in Quake. Twice this value
/// is twice as bright, and the brightest.
inline constexpr std::int32_t kFullLight = 128;

/// The shade, with 16 fraction bits, of a light value with 8 fraction bits, 0 to twice kFullLight; the inverse of
/// light_of_shade().
std::int32_t shade_of(std::int32_t light_8);

/// light_8 * brightness_100 / 100, clamped to the range of shades.
std::int32_t brightened(std::int32_t light_8, std::int32_t brightness_100);

/// The dials of light, and its brightness.
struct LightQuality {
    LightSampling sampling = LightSampling::Interpolated;
    std::int32_t shades = Colormap::kShades;  ///< 16, 32 or 64, from the brightest to the darkest
    bool dithers = false;
    std::int32_t brightness_100 = 100;  ///< percent of the stored light
    std::int32_t colour_levels = 0;     ///< Accuracy::colour_levels
    bool operator==(const LightQuality&) const = default;
};

/// The texels in a row or column of a lit surface: 16 >> mip for each cell between two light samples.
constexpr std::int32_t lit_size(std::int32_t samples, int mip) {
    return (samples - 1) * (16 >> mip);
}

/// A row of cells of a lit surface (build_lit_surface), at least one; each is between four light samples.
struct LitCells {
    const std::int32_t* upper_16;  ///< `columns` shades above the cells, followed by those below
    std::int32_t columns;
    const std::uint8_t* texels;  ///< the texture's first row for these cells
    std::int32_t first_u, texture_width;
    std::int32_t stride;  ///< of `out`
    std::uint8_t* out;
};
/// Lights cells of mip level 0 or 1 with interpolated shades, not dithered.
using CellKernel = void (*)(const LitCells& cells, int mip, const Colormap& colormap);

/// All samples of a level, in the same order: one value each, and red, green and blue.
struct ColouredLighting {
    const std::uint8_t* luminance = nullptr;
    const std::uint8_t* channels = nullptr;
};

/// What light is looked up in.
struct LightTables {
    const Colormap& colormap;          ///< for fewer than 64 shades from with_shades()
    CellKernel light_cells = nullptr;  ///< of this processor
    const ColourCube* cube = nullptr;  ///< this and the next: for build_coloured_surface() only
    ColouredLighting coloured{};
};

/// Ordered dithering (Bayer 1973) of 4x4 texels: a fraction is rounded up in this texel if it is in more than this many
/// of 16.
inline constexpr std::array<std::uint8_t, 16> kDitherThresholds{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};

/// A texture's coordinate from that of a surface, of any sign.
constexpr std::int32_t wrapped(std::int32_t texel, std::int32_t size) {
    const std::int32_t rest = texel % size;
    return rest < 0 ? rest + size : rest;
}

/// Writes texture times light to `out`: shades are interpolated in each cell between four samples, or taken from the
/// nearest one, and looked up in the colormap (Abrash, Black Book, ch. 68). They are rounded down, or with dithering
/// rounded up in as many of 4x4 texels as their fraction says. `out` has lit_size(rows) rows of `stride` bytes, at
/// least one; a surface without extent in a direction is one colour. `corner_shades` is scratch of columns * rows
/// entries.
void build_lit_surface(const TextureView& texture, const LightmapView& light, const LightTables& tables,
                       const LightQuality& quality, int mip, std::int32_t stride, std::int32_t* corner_shades,
                       std::uint8_t* out);

}  // namespace oblong
