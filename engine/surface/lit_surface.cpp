#include "engine/surface/lit_surface.h"

#include <algorithm>
#include <span>
#include <utility>

#include "engine/base/table.h"
#include "engine/fixed/fixed.h"

namespace oblong {

namespace {

constexpr std::int32_t kFull_8 = kFullLight * 256, kBrightest_8 = 2 * kFull_8;

/// Adds up the light of each sample, with 8 fraction bits.
void add_light(const LightmapView& light, std::span<std::int32_t> sums_8) {
    const std::size_t count = sums_8.size();
    if (light.added_8)
        std::copy_n(light.added_8, count, sums_8.begin());
    else
        std::fill(sums_8.begin(), sums_8.end(), 0);
    const std::uint8_t* samples = light.samples;
    for (std::int32_t style = 0; style < light.style_count; ++style, samples += count) {
        const std::int32_t scale_256 = item(light.style_scale_256, style);
        for (std::size_t i = 0; i < count; ++i) sums_8[i] += samples[i] * scale_256;
    }
}

void compute_corner_shades(const LightmapView& light, std::int32_t brightness_100, std::int32_t* corner_shades) {
    const std::span<std::int32_t> corners(corner_shades, as_size(light.columns * light.rows));
    if (light.has_no_lightmaps) return std::fill(corners.begin(), corners.end(), shade_of(kFull_8));
    add_light(light, corners);
    if (brightness_100 == 100) {  // without a test at each corner
        for (std::int32_t& corner : corners) corner = shade_of(std::clamp(corner, 0, kBrightest_8));
        return;
    }
    for (std::int32_t& corner : corners) corner = shade_of(brightened(corner, brightness_100));
}

/// Calls step(0), step(1) and so on: an unrolled loop, as a texel takes little more work than the loop itself.
template <int Count>
void repeat(auto step) {
    [&]<int... Number>(std::integer_sequence<int, Number...>) {
        (step(Number), ...);
    }
    (std::make_integer_sequence<int, Count>());
}

template <LightSampling Sampling, bool Dithers, int Mip>
class SurfaceBuilder {
  public:
    SurfaceBuilder(const TextureView& texture, const Colormap& colormap, const LightQuality& quality,
                   CellKernel light_cells)
        : texture_(texture),
          first_u_(wrapped(texture.min_u, texture.width)),
          colormap_(colormap),
          light_cells_(light_cells),
          threshold_24_(static_cast<std::uint32_t>(Colormap::kShades / quality.shades) << 20) {}

    /// For a surface without extent in one direction (a texture axis perpendicular to the face): one colour.
    void build_line(std::int32_t shade_16, std::int32_t bytes, std::uint8_t* out) const {
        const std::uint8_t texel = texels_at(wrapped(texture_.min_v, texture_.height))[first_u_];
        std::fill_n(out, bytes, item(colormap_.shades, shade_16 >> 16)[texel]);
    }

    void build(const LightmapView& light, const std::int32_t* corner_shades, std::int32_t stride,
               std::uint8_t* out) const {
        std::int32_t v = wrapped(texture_.min_v, texture_.height);
        for (std::int32_t y = 0; y < lit_size(light.rows, Mip); y += kCell) {
            build_cells(y, corner_shades, light.columns, texels_at(v), stride, out + y * stride);
            corner_shades += light.columns;
            v += kCell;  // the texture's height is whole cells, and the surface begins with one
            if (v == texture_.height) v = 0;
        }
    }

  private:
    static constexpr int kCellLog2 = 4 - Mip, kCell = 1 << kCellLog2;  ///< texels between two light samples
    static constexpr bool kInterpolates = Sampling == LightSampling::Interpolated;

    const std::uint8_t* texels_at(std::int32_t v) const { return texture_.texels + v * texture_.width; }

    /// Builds a row of cells from y on, below these corners.
    void build_cells(std::int32_t y, const std::int32_t* upper_16, std::int32_t columns, const std::uint8_t* texels,
                     std::int32_t stride, std::uint8_t* out) const {
        const std::int32_t width = texture_.width;
        if constexpr (kInterpolates && !Dithers && Mip < 2)
            if (light_cells_)
                return light_cells_({upper_16, columns, texels, first_u_, width, stride, out}, Mip, colormap_);
        std::int32_t u = first_u_;
        for (std::int32_t column = 1; column < columns; ++column, ++upper_16, out += kCell) {
            build_cell(y, upper_16, upper_16 + columns, texels + u, stride, out);
            u += kCell;  // the texture's width is whole cells, too
            if (u == width) u = 0;
        }
    }

    /// Steps the shade down the left and right side; with 20 fraction bits this is exact.
    void build_cell(std::int32_t y, const std::int32_t* upper_16, const std::int32_t* lower_16,
                    const std::uint8_t* texels, std::int32_t stride, std::uint8_t* out) const {
        std::int32_t left_20 = upper_16[0] * 16, right_20 = upper_16[1] * 16;
        const std::int32_t left_step_20 = kInterpolates ? (lower_16[0] - upper_16[0]) * (1 << Mip) : 0,
                           right_step_20 = kInterpolates ? (lower_16[1] - upper_16[1]) * (1 << Mip) : 0;
        const std::int32_t width = texture_.width;  // a copy, which byte writes cannot alias
        for (int row = 0; row < kCell; ++row, texels += width, out += stride) {
            if (!kInterpolates && 2 * row == kCell) left_20 = lower_16[0] * 16, right_20 = lower_16[1] * 16;
            build_cell_row(left_20, right_20, y + row, texels, out);
            left_20 += left_step_20;
            right_20 += right_step_20;
        }
    }

    std::uint32_t dithered(std::uint32_t shade_24, std::int32_t x, std::int32_t y) const {
        if constexpr (!Dithers) return shade_24;
        const std::uint32_t up = item(kDitherThresholds, (y & 3) * 4 + (x & 3)) * threshold_24_;
        return std::min(shade_24 + up, (std::uint32_t{Colormap::kShades} << 24) - 1);
    }

    /// Builds a row of one cell between the shades at its ends. With 24 fraction bits a texel's shade is exact and
    /// fits; if rounded, it could exceed the last shade.
    void build_cell_row(std::int32_t left_20, std::int32_t right_20, std::int32_t y, const std::uint8_t* texels,
                        std::uint8_t* out) const {
        const auto* const shades = colormap_.shades.data();
        const auto step_24 = static_cast<std::uint32_t>(kInterpolates ? (right_20 - left_20) * (1 << Mip) : 0);
        auto shade_24 = static_cast<std::uint32_t>(left_20 * 16);
        repeat<kCell>([&](int x) {
            if (!kInterpolates && 2 * x == kCell) shade_24 = static_cast<std::uint32_t>(right_20 * 16);
            out[x] = shades[dithered(shade_24, x, y) >> 24][texels[x]];
            shade_24 += step_24;
        });
    }

    const TextureView& texture_;
    std::int32_t first_u_;
    const Colormap& colormap_;
    const CellKernel light_cells_;
    std::uint32_t threshold_24_;  ///< a sixteenth of the step between two shades
};

template <LightSampling Sampling, bool Dithers, int Mip>
void build_mip(const TextureView& texture, const LightmapView& light, const Colormap& colormap,
               const LightQuality& quality, std::int32_t stride, const std::int32_t* corner_shades, std::uint8_t* out,
               CellKernel light_cells) {
    const SurfaceBuilder<Sampling, Dithers, Mip> builder(texture, colormap, quality, light_cells);
    if (light.columns < 2 || light.rows < 2)
        return builder.build_line(corner_shades[0], std::max(lit_size(light.rows, Mip), 1) * stride, out);
    builder.build(light, corner_shades, stride, out);
}

using Build = decltype(&build_mip<LightSampling::Interpolated, false, 0>);

template <LightSampling Sampling, bool Dithers>
constexpr std::array<Build, 4> kBuildOfMip{build_mip<Sampling, Dithers, 0>, build_mip<Sampling, Dithers, 1>,
                                           build_mip<Sampling, Dithers, 2>, build_mip<Sampling, Dithers, 3>};

Build build_of(const LightQuality& quality, int mip) {
    constexpr auto kNearest = LightSampling::Nearest, kInterpolated = LightSampling::Interpolated;
    if (quality.sampling == kNearest)
        return item(quality.dithers ? kBuildOfMip<kNearest, true> : kBuildOfMip<kNearest, false>, mip);
    return item(quality.dithers ? kBuildOfMip<kInterpolated, true> : kBuildOfMip<kInterpolated, false>, mip);
}

}  // namespace

std::int32_t brightened(std::int32_t light_8, std::int32_t brightness_100) {
    if (brightness_100 == 100) return std::clamp(light_8, 0, kBrightest_8);  // avoids the division
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(std::int64_t{light_8} * brightness_100 / 100, 0, kBrightest_8));
}

std::int32_t shade_of(std::int32_t light_8) {
    constexpr std::int32_t kOwn = Colormap::kOwnShade, kBrighter_16 = (kOwn << 16) / kFull_8,
                           kDarker_16 = ((Colormap::kShades - 1 - kOwn) << 16) / kFull_8;
    if (light_8 < kFull_8) return (kOwn << 16) + (kFull_8 - light_8) * kDarker_16;
    return (2 * kFull_8 - light_8) * kBrighter_16;
}

void build_lit_surface(const TextureView& texture, const LightmapView& light, const LightTables& tables,
                       const LightQuality& quality, int mip, std::int32_t stride, std::int32_t* corner_shades,
                       std::uint8_t* out) {
    compute_corner_shades(light, quality.brightness_100, corner_shades);
    build_of(quality, mip)(texture, light, tables.colormap, quality, stride, corner_shades, out, tables.light_cells);
}

}  // namespace oblong
