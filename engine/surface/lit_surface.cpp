#include "engine/surface/lit_surface.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/fixed/fixed.h"

namespace oblong {

namespace {

constexpr std::int32_t kDarkest_16 = (Colormap::kShades - 1) << 16;

/// The shade of a light value with 8 fraction bits: 0 from kFullLight up, the darkest at 0; 16 fraction bits.
std::int32_t shade_of(std::int32_t light_8) {
    const std::int64_t missing_8 = std::max(kFullLight * 256 - light_8, 0);
    return static_cast<std::int32_t>(missing_8 * kDarkest_16 / (kFullLight * 256));
}

void compute_corner_shades(const LightmapView& light, std::int32_t* corner_shades) {
    const std::int32_t count = light.columns * light.rows;
    for (std::int32_t i = 0; i < count; ++i) {
        std::int32_t sum_8 = 0;
        for (std::int32_t style = 0; style < light.style_count; ++style)
            sum_8 += light.samples[style * count + i] * at(light.style_scale_256, style);
        corner_shades[i] = light.is_fullbright ? 0 : shade_of(sum_8);
    }
}

std::int32_t wrap(std::int32_t value, std::int32_t size) {
    const std::int32_t rest = value % size;
    return rest < 0 ? rest + size : rest;
}

class SurfaceBuilder {
  public:
    SurfaceBuilder(const TextureView& texture, const Colormap& colormap, int mip)
        : texture_(texture), colormap_(colormap), cell_log2_(4 - mip) {}

    /// A surface without extent in one direction (a texture axis perpendicular to the face): one colour.
    void build_line(std::int32_t shade_16, std::int32_t bytes, std::uint8_t* out) const {
        const std::int32_t u = wrap(texture_.min_u, texture_.width), v = wrap(texture_.min_v, texture_.height);
        const std::uint8_t texel = texture_.texels[v * texture_.width + u];
        std::fill_n(out, bytes, at(colormap_.shades, shade_16 >> 16)[texel]);
    }

    void build_row(std::int32_t y, const std::int32_t* upper_16, std::int32_t columns, std::uint8_t* out) const {
        const std::int32_t down = y & ((1 << cell_log2_) - 1);
        const std::int32_t* lower_16 = upper_16 + columns;
        const std::uint8_t* texels = texture_.texels + wrap(texture_.min_v + y, texture_.height) * texture_.width;
        std::int32_t u = wrap(texture_.min_u, texture_.width);
        for (std::int32_t cell = 0; cell + 1 < columns; ++cell) {
            u = build_cell_row(blend(upper_16[cell], lower_16[cell], down),
                               blend(upper_16[cell + 1], lower_16[cell + 1], down), texels, u, out);
            out += 1 << cell_log2_;
        }
    }

  private:
    /// Between two shades with 16 fraction bits, `step` texels from the first: with 20, so that nothing is lost.
    std::int32_t blend(std::int32_t from_16, std::int32_t to_16, std::int32_t step) const {
        return from_16 * 16 + (to_16 - from_16) * (step << (4 - cell_log2_));
    }

    /// One row of texels of one cell, between two shades with 20 fraction bits. With 24 a texel's shade is exact and
    /// still fits: rounded, it could step past the last one. Returns u behind the row.
    std::int32_t build_cell_row(std::int32_t left_20, std::int32_t right_20, const std::uint8_t* texels, std::int32_t u,
                                std::uint8_t* out) const {
        const std::int32_t step_24 = (right_20 - left_20) * (1 << (4 - cell_log2_));
        std::int32_t shade_24 = left_20 * 16;
        for (std::int32_t x = 0; x < 1 << cell_log2_; ++x) {
            out[x] = at(colormap_.shades, shade_24 >> 24)[texels[u]];
            shade_24 += step_24;
            if (++u == texture_.width) u = 0;
        }
        return u;
    }

    const TextureView& texture_;
    const Colormap& colormap_;
    int cell_log2_;
};

}  // namespace

void build_lit_surface(const TextureView& texture, const LightmapView& light, const Colormap& colormap, int mip,
                       std::int32_t stride, std::int32_t* corner_shades, std::uint8_t* out) {
    compute_corner_shades(light, corner_shades);
    const SurfaceBuilder builder(texture, colormap, mip);
    const std::int32_t height = lit_size(light.rows, mip);
    if (light.columns < 2 || light.rows < 2)
        return builder.build_line(corner_shades[0], std::max(height, 1) * stride, out);
    for (std::int32_t y = 0; y < height; ++y)
        builder.build_row(y, corner_shades + (y >> (4 - mip)) * light.columns, light.columns,
                          out + static_cast<std::ptrdiff_t>(y) * stride);
}

}  // namespace oblong
