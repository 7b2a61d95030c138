#include "engine/surface/lit_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "engine/base/table.h"
#include "engine/raster/kernels/kernels.h"
#include "tests/support/palettes.h"

namespace oblong::test {

namespace {

struct Patch {
    std::int32_t columns, rows;
    std::vector<std::uint8_t> samples;
    std::vector<std::uint8_t> texels = std::vector<std::uint8_t>(64 * 64);
    std::vector<std::int32_t> scratch;

    Patch(std::mt19937& random, std::int32_t c, std::int32_t r) : columns(c), rows(r) {
        samples.resize(static_cast<std::size_t>(c * r));
        for (std::uint8_t& sample : samples) sample = static_cast<std::uint8_t>(random());
        for (std::uint8_t& texel : texels) texel = static_cast<std::uint8_t>(random());
        scratch.resize(samples.size());
    }

    std::vector<std::uint8_t> build(const Colormap& map, int mip, TextureView texture, std::uint16_t scale = 256,
                                    const LightQuality& quality = {}) {
        LightmapView light;
        light.samples = samples.data();
        light.columns = columns;
        light.rows = rows;
        light.style_count = 1;
        light.style_scale_256[0] = scale;
        const std::int32_t stride = lit_size(columns, mip);
        std::vector<std::uint8_t> out(static_cast<std::size_t>(stride * lit_size(rows, mip)));
        build_lit_surface(texture, light, {map}, quality, mip, stride, scratch.data(), out.data());
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
            const auto lit =
                patch.build(map, mip, {patch.texels.data(), 64, 64, 0, 0}, static_cast<std::uint16_t>(scale));
            ASSERT_EQ(std::count(lit.begin(), lit.end(), std::uint8_t{200}), std::ssize(lit))
                << "scale " << scale << ", mip " << mip;
        }
}

TEST(LitSurface, BrightnessMultipliesAllLightUpToTheBrightestShade) {
    std::mt19937 random(11);
    Patch patch(random, 2, 2);
    const TextureView texture{patch.texels.data(), 64, 64, 0, 0};
    for (const std::int32_t brightness_100 : {0, 25, 99, 100, 150, 800, std::numeric_limits<std::int32_t>::max()})
        for (int light = 0; light < 256; light += 5) {
            patch.samples.assign(4, static_cast<std::uint8_t>(light));
            LightQuality quality;
            quality.brightness_100 = brightness_100;
            const double shade = shade_in_doubles(std::floor(light * 256.0 * brightness_100 / 100) / 256);
            EXPECT_EQ(patch.build(numbered_shades(), 0, texture, 256, quality)[0], std::floor(shade))
                << light << " at " << brightness_100;
        }
}

TEST(LitSurface, ALevelWithoutLightShowsItsOwnColours) {
    std::mt19937 random(12);
    Patch patch(random, 2, 2);
    LightmapView light;
    light.columns = light.rows = 2;
    light.has_no_lightmaps = true;
    std::vector<std::uint8_t> out(256);
    const Colormap map = numbered_shades();
    build_lit_surface({patch.texels.data(), 64, 64, 0, 0}, light, {map}, {}, 0, 16, patch.scratch.data(), out.data());
    EXPECT_EQ(std::count(out.begin(), out.end(), std::uint8_t{Colormap::kOwnShade}), 256);
}

TEST(LitSurface, WithoutExtentIsOneColourAndWritesAllOfIt) {
    std::mt19937 random(9);
    const Colormap map = numbered_shades();
    for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 5}, {5, 1}}) {
        Patch patch(random, columns, rows);
        LightmapView light;
        light.samples = patch.samples.data();
        light.columns = columns;
        light.rows = rows;
        light.style_count = 1;
        light.style_scale_256[0] = 256;
        const std::int32_t stride = std::max(lit_size(columns, 0), 1), height = std::max(lit_size(rows, 0), 1);
        std::vector<std::uint8_t> out(static_cast<std::size_t>(stride * height), 0xa5);
        build_lit_surface({patch.texels.data(), 64, 64, 16, 16}, light, {map}, {}, 0, stride, patch.scratch.data(),
                          out.data());
        const int shade = static_cast<int>(shade_in_doubles(patch.samples[0]));
        EXPECT_EQ(std::count(out.begin(), out.end(), static_cast<std::uint8_t>(shade)), stride * height);
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
        constexpr int kBayer[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
        shade_24 += kBayer[y % 4][x % cell % 4] * (64 / quality.shades << 20);
        shade_24 = std::min<std::int64_t>(shade_24, (64 << 24) - 1);
    }
    const auto wrapped = [](std::int32_t place, std::int32_t size) { return ((place % size) + size) % size; };
    const std::int32_t u = wrapped(texture.min_u + x, texture.width), v = wrapped(texture.min_v + y, texture.height);
    return item(map.shades, shade_24 >> 24)[texture.texels[v * texture.width + u]];
}

TEST(LitSurface, EachTexelIsWhatTheFormulaSays) {
    std::mt19937 random(31);
    Colormap map;
    for (auto& shade : map.shades)
        for (std::uint8_t& colour : shade) colour = static_cast<std::uint8_t>(random());
    const auto below = [&](std::uint32_t end) { return static_cast<std::int32_t>(random() % end); };
    for (int round = 0; round < 600; ++round) {
        const int mip = below(4), cell = 16 >> mip;
        Patch patch(random, 2 + below(5), 2 + below(5));
        const TextureView texture{patch.texels.data(), (1 + below(64 / cell)) * cell, (1 + below(64 / cell)) * cell,
                                  (below(90) - 45) * cell, (below(90) - 45) * cell};
        const LightQuality quality{below(2) ? LightSampling::Nearest : LightSampling::Interpolated, 16 << below(3),
                                   below(2) == 0, below(4) == 0 ? 25 + below(700) : 100};
        LightmapView light;
        light.columns = patch.columns;
        light.rows = patch.rows;
        light.style_count = below(5);
        const auto samples = static_cast<std::size_t>(light.columns * light.rows);
        std::vector<std::uint8_t> styles(samples * 4);
        for (std::uint8_t& sample : styles) sample = static_cast<std::uint8_t>(random());
        for (std::uint16_t& scale : light.style_scale_256) scale = static_cast<std::uint16_t>(below(600));
        std::vector<std::int32_t> added(samples);
        for (std::int32_t& sum : added) sum = below(40'000);
        light.samples = styles.data();
        if (below(3) == 0) light.added_8 = added.data();
        const std::int32_t width = lit_size(light.columns, mip), height = lit_size(light.rows, mip), stride = width + 3;
        for (const Kernels& kernels : all_kernels()) {
            std::vector<std::uint8_t> out(static_cast<std::size_t>(stride * height), 77);
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
        const TextureView texture{patch.texels.data(), 64, 64, 0, 0};
        const auto mean_of = [&](bool dithers) {
            const auto lit =
                patch.build(numbered_shades(), 0, texture, 256, {LightSampling::Interpolated, 64, dithers});
            return std::accumulate(lit.begin(), lit.end(), 0.0) / static_cast<double>(lit.size());
        };
        const double shade = shade_in_doubles(light);
        EXPECT_NEAR(mean_of(true), shade, 1.0 / 16) << light;
        EXPECT_EQ(mean_of(false), std::floor(shade)) << light;
    }
}

}  // namespace oblong::test
