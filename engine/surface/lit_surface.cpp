#include "engine/surface/lit_surface.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/fixed/fixed.h"

namespace oblong {

namespace {

constexpr std::int32_t kFull_8 = kFullLight * 256;

/// At most the brightest light that a shade shows.
std::int32_t brightened(std::int64_t light_8, std::int32_t brightness_100) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(light_8 * brightness_100 / 100, 0, 2 * kFull_8));
}

void compute_corner_shades(const LightmapView& light, std::int32_t brightness_100, std::int32_t* corner_shades) {
    const std::int32_t count = light.columns * light.rows;
    for (std::int32_t i = 0; i < count; ++i) {
        std::int32_t sum_8 = light.added_8 ? light.added_8[i] : 0;
        for (std::int32_t style = 0; style < light.style_count; ++style)
            sum_8 += light.samples[style * count + i] * at(light.style_scale_256, style);
        corner_shades[i] = shade_of(light.is_fullbright ? kFull_8 : brightened(sum_8, brightness_100));
    }
}

std::int32_t wrap(std::int32_t value, std::int32_t size) {
    const std::int32_t rest = value % size;
    return rest < 0 ? rest + size : rest;
}

/// Ordered dithering (Bayer 1973): in how many of 16 texels a fraction must be rounded up before it is in this one.
constexpr std::array<std::uint8_t, 16> kThresholds{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};

template <LightSampling Sampling, bool Dithers>
class SurfaceBuilder {
  public:
    SurfaceBuilder(const TextureView& texture, const Colormap& colormap, const LightQuality& quality, int mip)
        : texture_(texture),
          colormap_(colormap),
          threshold_24_((Colormap::kShades / quality.shades) << 20),
          cell_log2_(4 - mip) {}

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
            u = build_cell_row(
                {blend(upper_16[cell], lower_16[cell], down), blend(upper_16[cell + 1], lower_16[cell + 1], down), y},
                texels, u, out);
            out += 1 << cell_log2_;
        }
    }

  private:
    /// A row of texels of one cell: the shades at its ends, with 20 fraction bits.
    struct CellRow {
        std::int32_t left_20, right_20, y;
    };

    /// Between two shades with 16 fraction bits, `step` texels from the first: with 20, so that nothing is lost.
    std::int32_t blend(std::int32_t from_16, std::int32_t to_16, std::int32_t step) const {
        if constexpr (Sampling == LightSampling::Nearest) return (2 * step < 1 << cell_log2_ ? from_16 : to_16) * 16;
        return from_16 * 16 + (to_16 - from_16) * (step << (4 - cell_log2_));
    }

    std::uint8_t shaded(std::int32_t shade_24, std::int32_t x, std::int32_t y, std::uint8_t texel) const {
        if constexpr (Dithers) {
            const std::int32_t up = kThresholds[static_cast<std::size_t>((y & 3) * 4 + (x & 3))] * threshold_24_;
            shade_24 = std::min(shade_24 + up, (Colormap::kShades << 24) - 1);
        }
        return at(colormap_.shades, shade_24 >> 24)[texel];
    }

    /// With 24 fraction bits a texel's shade is exact and still fits: rounded, it could step past the last one. Returns
    /// u behind the row.
    std::int32_t build_cell_row(const CellRow& row, const std::uint8_t* texels, std::int32_t u,
                                std::uint8_t* out) const {
        constexpr bool kSteps = Sampling == LightSampling::Interpolated;
        const std::int32_t size = 1 << cell_log2_;
        const std::int32_t step_24 = kSteps ? (row.right_20 - row.left_20) * (1 << (4 - cell_log2_)) : 0;
        std::int32_t shade_24 = row.left_20 * 16;
        for (std::int32_t x = 0; x < size; ++x) {
            if (!kSteps && 2 * x == size) shade_24 = row.right_20 * 16;
            out[x] = shaded(shade_24, x, row.y, texels[u]);
            shade_24 += step_24;
            if (++u == texture_.width) u = 0;
        }
        return u;
    }

    const TextureView& texture_;
    const Colormap& colormap_;
    std::int32_t threshold_24_;  ///< a sixteenth of the step between two shades
    int cell_log2_;
};

template <LightSampling Sampling, bool Dithers>
void build_surface(const TextureView& texture, const LightmapView& light, const Colormap& colormap,
                   const LightQuality& quality, int mip, std::int32_t stride, const std::int32_t* corner_shades,
                   std::uint8_t* out) {
    const SurfaceBuilder<Sampling, Dithers> builder(texture, colormap, quality, mip);
    const std::int32_t height = lit_size(light.rows, mip);
    if (light.columns < 2 || light.rows < 2)
        return builder.build_line(corner_shades[0], std::max(height, 1) * stride, out);
    for (std::int32_t y = 0; y < height; ++y)
        builder.build_row(y, corner_shades + (y >> (4 - mip)) * light.columns, light.columns,
                          out + static_cast<std::ptrdiff_t>(y) * stride);
}

}  // namespace

std::int32_t shade_of(std::int32_t light_8) {
    constexpr std::int32_t kOwn = Colormap::kOwnShade, kBrighter_16 = (kOwn << 16) / kFull_8,
                           kDarker_16 = ((Colormap::kShades - 1 - kOwn) << 16) / kFull_8;
    if (light_8 < kFull_8) return (kOwn << 16) + (kFull_8 - light_8) * kDarker_16;
    return (2 * kFull_8 - light_8) * kBrighter_16;
}

void build_lit_surface(const TextureView& texture, const LightmapView& light, const Colormap& colormap,
                       const LightQuality& quality, int mip, std::int32_t stride, std::int32_t* corner_shades,
                       std::uint8_t* out) {
    compute_corner_shades(light, quality.brightness_100, corner_shades);
    const bool interpolates = quality.sampling == LightSampling::Interpolated;
    const auto build = interpolates ? (quality.dithers ? build_surface<LightSampling::Interpolated, true>
                                                       : build_surface<LightSampling::Interpolated, false>)
                                    : (quality.dithers ? build_surface<LightSampling::Nearest, true>
                                                       : build_surface<LightSampling::Nearest, false>);
    build(texture, light, colormap, quality, mip, stride, corner_shades, out);
}

}  // namespace oblong
