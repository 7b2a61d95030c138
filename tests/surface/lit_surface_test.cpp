#include "engine/surface/lit_surface.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/raster/kernels/kernels.h"
#include "tests/surface/true_surface.h"

namespace oblong::test {

namespace {

struct Patch {
    std::int32_t columns, rows;
    std::vector<std::uint8_t> samples;
    std::vector<std::uint8_t> texels = std::vector<std::uint8_t>(64 * 64);
    std::vector<std::int32_t> scratch;
    TextureView texture{texels.data(), 64, 64, 0, 0};

    Patch(std::mt19937& random, std::int32_t c, std::int32_t r)
        : columns(c), rows(r), samples(as_size(c * r)), scratch(samples.size()) {
        fill_at_random(samples, random);
        fill_at_random(texels, random);
    }

    LightmapView light(std::uint16_t scale = 256) const {
        return {samples.data(), columns, rows, 1, {scale}, nullptr, false};
    }
    /// At least a texel each way.
    std::vector<std::uint8_t> build(const Colormap& map, const LightmapView& by, const LightQuality& quality = {},
                                    int mip = 0) {
        const std::int32_t stride = std::max(lit_size(columns, mip), 1), height = std::max(lit_size(rows, mip), 1);
        std::vector<std::uint8_t> out(as_size(stride * height), 0xa5);
        build_lit_surface(texture, by, {map}, quality, mip, stride, scratch.data(), out.data());
        return out;
    }
};

}  // namespace

TEST(LitSurface, LightJustBelowTheBrightestIsTheFirstShadeForEveryScale) {
    // No step on the way may be rounded past the brightest shade: before it there is none.
    constexpr std::uint32_t kBrightest_8 = 2 * kFullLight * 256;
    std::mt19937 random(10);
    Colormap map = numbered_shades();
    map.shades[0].fill(200);
    for (int mip = 0; mip < 4; ++mip)
        for (std::uint32_t scale = 258; scale < 2048; ++scale) {
            Patch patch(random, 2, 2);
            std::fill(patch.samples.begin(), patch.samples.end(), std::uint8_t{255});
            patch.samples[0] = static_cast<std::uint8_t>((kBrightest_8 - 1) / scale);
            if (kBrightest_8 - patch.samples[0] * scale > 1000) continue;  // less than shade 1
            const auto lit = patch.build(map, patch.light(static_cast<std::uint16_t>(scale)), {}, mip);
            ASSERT_EQ(std::count(lit.begin(), lit.end(), std::uint8_t{200}), std::ssize(lit))
                << "scale " << scale << ", mip " << mip;
        }
}

TEST(LitSurface, BrightnessMultipliesAllLightUpToTheBrightestShade) {
    std::mt19937 random(11);
    Patch patch(random, 2, 2);
    for (const std::int32_t brightness_100 : {0, 25, 99, 100, 150, 800, std::numeric_limits<std::int32_t>::max()})
        for (int light = 0; light < 256; light += 5) {
            patch.samples.assign(4, static_cast<std::uint8_t>(light));
            LightQuality quality;
            quality.brightness_100 = brightness_100;
            const double shade = shade_in_doubles(std::floor(light * 256.0 * brightness_100 / 100) / 256);
            EXPECT_EQ(patch.build(numbered_shades(), patch.light(), quality)[0], std::floor(shade))
                << light << " at " << brightness_100;
        }
}

TEST(LitSurface, ALevelWithoutLightShowsItsOwnColours) {
    std::mt19937 random(12);
    Patch patch(random, 2, 2);
    LightmapView light;
    light.columns = light.rows = 2;
    light.has_no_lightmaps = true;
    EXPECT_EQ(patch.build(numbered_shades(), light), std::vector<std::uint8_t>(256, Colormap::kOwnShade));
}

TEST(LitSurface, WithoutExtentIsOneColourAndWritesAllOfIt) {
    std::mt19937 random(9);
    for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 5}, {5, 1}}) {
        Patch patch(random, columns, rows);
        patch.texture.min_u = patch.texture.min_v = 16;
        const std::vector<std::uint8_t> out = patch.build(numbered_shades(), patch.light());
        const auto shade = static_cast<std::uint8_t>(shade_in_doubles(patch.samples[0]));
        EXPECT_EQ(std::count(out.begin(), out.end(), shade),
                  std::max(16 * (columns - 1), 1) * std::max(16 * (rows - 1), 1));
    }
}

/// One texel by the formula, in integers.
std::uint8_t plain_texel(const TextureView& texture, const LightmapView& light, const Colormap& map,
                         const LightQuality& quality, int mip, std::int32_t x, std::int32_t y) {
    const std::int32_t cell = 16 >> mip, column = x / cell, row = y / cell;
    const bool is_nearest = quality.sampling == LightSampling::Nearest;
    const auto sample_16 = [&](std::int32_t c, std::int32_t r) {
        const std::int32_t index = r * light.columns + c;
        std::int64_t light_8 = light.added_8 ? light.added_8[index] : 0;
        for (std::int32_t style = 0; style < light.style_count; ++style)
            light_8 += light.samples[style * light.columns * light.rows + index] * item(light.style_scale_256, style);
        light_8 = std::clamp<std::int64_t>(light_8 * quality.brightness_100 / 100, 0, 2 * kFullLight * 256);
        return std::int64_t{oblong::shade_of(static_cast<std::int32_t>(light_8))};
    };
    const auto between = [&](std::int64_t a, std::int64_t b, std::int32_t step) {  // a and b times the cell's size
        if (is_nearest) return (2 * step < cell ? a : b) * cell;
        return a * cell + (b - a) * step;
    };
    const std::int64_t left = between(sample_16(column, row), sample_16(column, row + 1), y % cell),
                       right = between(sample_16(column + 1, row), sample_16(column + 1, row + 1), y % cell);
    std::int64_t shade_24 = between(left, right, x % cell) * (1 << 2 * mip);
    if (quality.dithers) {
        shade_24 += dither_16(x % cell, y) * (64 / quality.shades << 20);
        shade_24 = std::min<std::int64_t>(shade_24, (64 << 24) - 1);
    }
    return item(map.shades, shade_24 >> 24)[wrapped_texel(texture, x, y)];
}

TEST(LitSurface, EachTexelIsWhatTheFormulaSays) {
    std::mt19937 random(31);
    Colormap map;
    for (auto& shade : map.shades) fill_at_random(shade, random);
    const auto below = [&](std::int32_t end) { return random_below(random, end); };
    for (int round = 0; round < 600; ++round) {
        const int mip = below(4), cell = 16 >> mip;
        Patch patch(random, 2 + below(5), 2 + below(5));
        const TextureView texture{patch.texels.data(), (1 + below(64 / cell)) * cell, (1 + below(64 / cell)) * cell,
                                  (below(90) - 45) * cell, (below(90) - 45) * cell};
        const LightQuality quality{below(2) ? LightSampling::Nearest : LightSampling::Interpolated, 16 << below(3),
                                   below(2) == 0, below(4) == 0 ? 25 + below(700) : 100};
        std::vector<std::uint8_t> styles(patch.samples.size() * 4);
        fill_at_random(styles, random);
        std::vector<std::int32_t> added(patch.samples.size());
        for (std::int32_t& sum : added) sum = below(40'000);
        LightmapView light = patch.light();
        light.samples = styles.data();
        light.style_count = below(5);
        for (std::uint16_t& scale : light.style_scale_256) scale = static_cast<std::uint16_t>(below(600));
        if (below(3) == 0) light.added_8 = added.data();
        const std::int32_t width = lit_size(light.columns, mip), height = lit_size(light.rows, mip), stride = width + 3;
        for (const Kernels& kernels : all_kernels()) {
            std::vector<std::uint8_t> out(as_size(stride * height), 77);
            build_lit_surface(texture, light, {map, kernels.light_cells}, quality, mip, stride, patch.scratch.data(),
                              out.data());
            for (std::int32_t y = 0; y < height; ++y)
                for (std::int32_t x = 0; x < stride; ++x)
                    ASSERT_EQ(item(out, y * stride + x),
                              x < width ? plain_texel(texture, light, map, quality, mip, x, y) : 77)
                        << x << "," << y << " of round " << round << ", " << kernels.name;
        }
    }
}

/// Over 4x4 texels of the same light a dithered shade is right on average to 1/16 of a shade; a plain one is up to one
/// too bright.
TEST(LightQuality, DitheredLightIsRightOnAverage) {
    std::mt19937 random(22);
    for (int light = 3; light < 256; light += 4) {
        Patch patch(random, 2, 2);
        patch.samples.assign(4, static_cast<std::uint8_t>(light));
        const auto mean_of = [&](bool dithers) {
            const LightQuality quality{LightSampling::Interpolated, 64, dithers};
            const auto lit = patch.build(numbered_shades(), patch.light(), quality);
            return std::accumulate(lit.begin(), lit.end(), 0.0) / static_cast<double>(lit.size());
        };
        const double shade = shade_in_doubles(light);
        EXPECT_NEAR(mean_of(true), shade, 1.0 / 16) << light;
        EXPECT_EQ(mean_of(false), std::floor(shade)) << light;
    }
}

}  // namespace oblong::test
