#include "engine/surface/coloured_surface.h"

#include <algorithm>

#include "engine/base/table.h"

namespace oblong {
namespace {

/// Light of red, green and blue.
using Channels = std::array<std::int32_t, 3>;

Channels times(const std::int32_t* channels, std::int32_t factor) {
    return {channels[0] * factor, channels[1] * factor, channels[2] * factor};
}

Channels step_between(const std::int32_t* from, const std::int32_t* to, std::int32_t factor) {
    return {(to[0] - from[0]) * factor, (to[1] - from[1]) * factor, (to[2] - from[2]) * factor};
}

void step(Channels& light, const Channels& by) {
    for (std::size_t i = 0; i < 3; ++i) light[i] += by[i];
}

/// Fills `corners` with the light at the samples: red, green and blue of each.
void add_up_light(const LightmapView& light, const ColouredLighting& lighting, std::int32_t brightness_100,
                  std::int32_t* corners) {
    const std::size_t count = as_size(light.columns * light.rows);
    for (std::size_t i = 0; i < 3 * count; ++i) corners[i] = light.added_8 ? light.added_8[i / 3] : 0;
    for (std::int32_t style = 0; style < light.style_count; ++style) {
        const std::uint8_t* const channels = lighting.channels + 3 * (light.samples - lighting.luminance);
        const std::size_t first = 3 * count * as_size(style);
        for (std::size_t i = 0; i < 3 * count; ++i)
            corners[i] += channels[first + i] * item(light.style_scale_256, style);
    }
    for (std::size_t i = 0; i < 3 * count; ++i) corners[i] = brightened(corners[i], brightness_100);
}

/// What rounds a level with 31 fraction bits: a half, or by the dithering pattern.
template <bool Dithers>
std::int64_t up_31(std::int32_t x, std::int32_t y) {
    if constexpr (!Dithers) return std::int64_t{1} << 30;
    return std::int64_t{2 * item(kDitherThresholds, (y & 3) * 4 + (x & 3)) + 1} << 26;
}

/// A place in a surface, for the dithering pattern.
struct Place {
    std::int32_t x, y;
};

/// Texels of a row. A level has 31 fraction bits: 8 of ColourCube::levels_8, and 23 of light, of which 15 are of full
/// light with 8 fraction bits, and 8 more make steps between samples exact.
template <bool Dithers>
void fill_row(const ColourCube& cube, const std::uint8_t* texels, std::int32_t count, const Channels& first_16,
              const Channels& step_16, Place place, std::uint8_t* out) {
    const std::uint8_t* const nearest = cube.nearest.data();
    std::int64_t red_16 = first_16[0], green_16 = first_16[1], blue_16 = first_16[2];
    for (std::int32_t x = 0; x < count; ++x) {
        const auto& full_8 = cube.levels_8[texels[x]];
        const std::int64_t up = up_31<Dithers>(place.x + x, place.y);
        const std::int32_t entry = cube.parts[0][static_cast<std::size_t>((full_8[0] * red_16 + up) >> 31)] +
                                   cube.parts[1][static_cast<std::size_t>((full_8[1] * green_16 + up) >> 31)] +
                                   cube.parts[2][static_cast<std::size_t>((full_8[2] * blue_16 + up) >> 31)];
        out[x] = texels[x] < kFirstFullbright ? nearest[entry] : texels[x];
        red_16 += step_16[0];
        green_16 += step_16[1];
        blue_16 += step_16[2];
    }
}

/// Writes the texels between four light samples, 16 a side at mip level 0.
class CellBuilder {
  public:
    CellBuilder(const ColourCube& cube, const LightQuality& quality, int mip)
        : cube_(cube),
          mip_(mip),
          size_(16 >> mip),
          is_nearest_(quality.sampling == LightSampling::Nearest),
          fill_row_(quality.dithers ? fill_row<true> : fill_row<false>) {}

    std::int32_t size() const { return size_; }

    /// `upper_8`, `lower_8`: the light at the corners, left and right; `out`: of the whole surface.
    void build(const std::int32_t* upper_8, const std::int32_t* lower_8, const std::uint8_t* texels, std::int32_t width,
               Place place, std::int32_t stride, std::uint8_t* out) const {
        out += place.y * stride + place.x;
        if (is_nearest_) return build_quarters(upper_8, lower_8, texels, width, place, stride, out);
        Channels left_12 = times(upper_8, 16), right_12 = times(upper_8 + 3, 16);
        const Channels left_step = step_between(upper_8, lower_8, 1 << mip_),
                       right_step = step_between(upper_8 + 3, lower_8 + 3, 1 << mip_);
        for (std::int32_t y = 0; y < size_; ++y, ++place.y, texels += width, out += stride) {
            const Channels step_16 = step_between(left_12.data(), right_12.data(), 1 << mip_);
            fill_row_(cube_, texels, size_, times(left_12.data(), 16), step_16, place, out);
            step(left_12, left_step);
            step(right_12, right_step);
        }
    }

  private:
    /// Each texel has the light of the nearest sample.
    void build_quarters(const std::int32_t* upper_8, const std::int32_t* lower_8, const std::uint8_t* texels,
                        std::int32_t width, Place place, std::int32_t stride, std::uint8_t* out) const {
        const std::int32_t half = size_ / 2;
        for (std::int32_t y = 0; y < size_; ++y, ++place.y, texels += width, out += stride) {
            const std::int32_t* const row_8 = y < half ? upper_8 : lower_8;
            fill_row_(cube_, texels, half, times(row_8, 256), {}, place, out);
            fill_row_(cube_, texels + half, half, times(row_8 + 3, 256), {}, {place.x + half, place.y}, out + half);
        }
    }

    const ColourCube& cube_;
    int mip_;
    std::int32_t size_;
    bool is_nearest_;
    decltype(&fill_row<false>) fill_row_;
};

}  // namespace

std::uint8_t coloured_texel(const ColourCube& cube, std::uint8_t texel, const std::array<std::int32_t, 3>& light_8) {
    std::uint8_t colour = 0;
    fill_row<false>(cube, &texel, 1, times(light_8.data(), 256), {}, {0, 0}, &colour);
    return colour;
}

void build_coloured_surface(const TextureView& texture, const LightmapView& light, const LightTables& tables,
                            const LightQuality& quality, int mip, std::int32_t stride, std::int32_t* corners,
                            std::uint8_t* out) {
    add_up_light(light, tables.coloured, quality.brightness_100, corners);
    const CellBuilder cells(*tables.cube, quality, mip);
    const std::int32_t size = cells.size(), first_u = wrapped(texture.min_u, texture.width);
    std::int32_t v = wrapped(texture.min_v, texture.height);
    if (light.columns < 2 || light.rows < 2) {
        const std::uint8_t texel = texture.texels[v * texture.width + first_u];
        const std::uint8_t colour = coloured_texel(*tables.cube, texel, {corners[0], corners[1], corners[2]});
        std::fill_n(out, std::max(lit_size(light.rows, mip), 1) * stride, colour);
        return;
    }
    for (std::int32_t row = 0; row + 1 < light.rows; ++row, corners += 3 * light.columns) {
        for (std::int32_t column = 0; column + 1 < light.columns; ++column) {
            const std::int32_t u = (first_u + column * size) % texture.width;
            const std::int32_t* const upper = corners + 3 * column;
            cells.build(upper, upper + 3 * light.columns, texture.texels + v * texture.width + u, texture.width,
                        {column * size, row * size}, stride, out);
        }
        v = (v + size) % texture.height;
    }
}

}  // namespace oblong
