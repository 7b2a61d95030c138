#include "engine/surface/coloured_surface.h"

#include <gtest/gtest.h>

#include "tests/surface/true_surface.h"

namespace oblong::coloured_surface_test {
namespace {

using namespace test;

TEST(ColourCube, EachEntryIsTheNearestOrdinaryColour) {
    std::mt19937 random(71);
    const Palette palette = random_palette(random);
    const ColourCube cube = make_colour_cube(palette, 16);
    ASSERT_EQ(cube.nearest.size(), 16u * 16 * 16);
    for (int i = 0; i < 16 * 16 * 16; ++i) {
        const TrueOklab target = true_oklab(i / 256 * 17, i / 16 % 16 * 17, i % 16 * 17);
        const auto distance_to = [&](std::size_t colour) { return distance(seen(palette.colours[colour]), target); };
        double nearest = 10;
        for (std::size_t colour = 0; colour < kFirstFullbright; ++colour)
            nearest = std::min(nearest, distance_to(colour));
        ASSERT_LT(item(cube.nearest, i), kFirstFullbright);
        EXPECT_LE(distance_to(item(cube.nearest, i)), nearest + 0.001) << i;
    }
}

constexpr std::int32_t kLevels = 6;

/// Entry i is colour i: what is drawn says which levels were looked up.
ColourCube numbered_cube(const Palette& palette) {
    ColourCube cube = make_colour_cube(palette, kLevels);
    std::iota(cube.nearest.begin(), cube.nearest.end(), std::uint8_t{0});
    return cube;
}

/// A surface of random light in a random texture, and its light in doubles.
struct Surface {
    std::mt19937& random;
    std::int32_t mip = below(4), cell = 16 >> mip, columns = 2 + below(4), rows = 2 + below(4);
    std::vector<std::uint8_t> texels = bytes(64 * 64), channels = bytes(12 * columns * rows), luminance = bytes(1);
    std::vector<std::int32_t> added = std::vector<std::int32_t>(as_size(columns * rows));
    TextureView texture{texels.data(), (1 + below(64 / cell)) * cell, (1 + below(64 / cell)) * cell,
                        (below(90) - 45) * cell, (below(90) - 45) * cell};
    LightQuality quality{below(2) ? LightSampling::Nearest : LightSampling::Interpolated, 64, below(2) == 0,
                         below(4) == 0 ? 25 + below(300) : 100};
    LightmapView light{luminance.data(), columns, rows, below(5), {}, nullptr, false};

    explicit Surface(std::mt19937& numbers) : random(numbers) {
        for (std::uint16_t& scale : light.style_scale_256) scale = static_cast<std::uint16_t>(below(400));
        for (std::int32_t& sum : added) sum = below(20'000);
        if (below(3) == 0) light.added_8 = added.data();
    }
    std::int32_t below(std::int32_t end) { return random_below(random, end); }
    std::vector<std::uint8_t> bytes(std::int32_t count) {
        std::vector<std::uint8_t> all(as_size(count));
        fill_at_random(all, random);
        return all;
    }

    std::vector<std::uint8_t> build(const ColourCube& cube, std::int32_t stride, std::int32_t height) {
        std::vector<std::uint8_t> out(as_size(stride * height), 250);
        std::vector<std::int32_t> scratch(3 * added.size() + 15);
        const Colormap unused{};
        build_coloured_surface(texture, light, {unused, nullptr, &cube, {luminance.data(), channels.data()}}, quality,
                               mip, stride, scratch.data(), out.data());
        return out;
    }
    /// 1: full light.
    double light_of_sample(std::int32_t column, std::int32_t row, int channel) const {
        const std::int32_t sample = row * columns + column;
        double sum = light.added_8 ? item(added, sample) : 0;
        for (std::int32_t style = 0; style < light.style_count; ++style)
            sum += item(channels, 3 * (style * columns * rows + sample) + channel) * item(light.style_scale_256, style);
        return std::min(sum * quality.brightness_100 / 100 / 256 / kFullLight, 2.0);
    }
    double light_at(std::int32_t x, std::int32_t y, int channel) const {
        const auto part = [&](std::int32_t place) {
            const double exact = static_cast<double>(place % cell) / cell;
            return quality.sampling == LightSampling::Nearest ? std::floor(exact * 2) : exact;
        };
        const auto in_row = [&](std::int32_t row) {
            return std::lerp(light_of_sample(x / cell, row, channel), light_of_sample(x / cell + 1, row, channel),
                             part(x));
        };
        return std::lerp(in_row(y / cell), in_row(y / cell + 1), part(y));
    }
};

TEST(ColouredSurface, EachTexelIsItsColourTimesTheLightOfEachChannel) {
    std::mt19937 random(72);
    const Palette palette = random_palette(random);
    const ColourCube cube = numbered_cube(palette);
    for (int round = 0; round < 300; ++round) {
        Surface surface(random);
        const std::int32_t width = lit_size(surface.columns, surface.mip), stride = width + 3,
                           height = lit_size(surface.rows, surface.mip);
        const std::vector<std::uint8_t> out = surface.build(cube, stride, height);
        for (std::int32_t y = 0; y < height; ++y) {
            ASSERT_EQ(item(out, y * stride + width), 250) << "beyond the surface";
            for (std::int32_t x = 0; x < width; ++x) {
                const std::uint8_t found = item(out, y * stride + x), texel = wrapped_texel(surface.texture, x, y);
                if (texel >= kFirstFullbright) {
                    ASSERT_EQ(found, texel);
                    continue;
                }
                const Rgb8& full = palette.colours[texel];
                const int up_16 = surface.quality.dithers ? dither_16(x, y) : 8;
                for (int channel = 0; channel < 3; ++channel) {
                    const int level = found / (channel == 0 ? 36 : channel == 1 ? 6 : 1) % 6;
                    const double of_255 = channel == 0 ? full.red : channel == 1 ? full.green : full.blue;
                    const double exact = of_255 / 255 * (kLevels - 1) * surface.light_at(x, y, channel);
                    const double above = exact + (up_16 + (surface.quality.dithers ? 0.5 : 0)) / 16 - level;
                    constexpr double kRounding = 0.005;  // of levels_8, at twice full light
                    ASSERT_GE(above, -kRounding) << x << "," << y << " of round " << round;
                    ASSERT_TRUE(level == kLevels - 1 || above <= 1 + kRounding)
                        << x << "," << y << " of round " << round;
                }
            }
        }
    }
}

TEST(ColouredSurface, WithoutExtentIsOneColourAndWritesAllOfIt) {
    std::mt19937 random(73);
    const ColourCube cube = numbered_cube(grey_palette());
    for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 5}, {5, 1}}) {
        Surface surface(random);
        surface.light.columns = surface.columns = columns;
        surface.light.rows = surface.rows = rows;
        surface.mip = 0;
        surface.texels.assign(surface.texels.size(), 200);
        const std::int32_t stride = std::max(lit_size(columns, 0), 1), height = std::max(lit_size(rows, 0), 1);
        surface.quality = {};
        const std::vector<std::uint8_t> out = surface.build(cube, stride, height);
        EXPECT_EQ(std::count(out.begin(), out.end(), out[0]), stride * height);
        EXPECT_NE(out[0], 250);
    }
}

}  // namespace
}  // namespace oblong::coloured_surface_test
