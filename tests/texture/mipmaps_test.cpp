#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/pictures/picture.h"
#include "engine/surface/colormap.h"
#include "tests/texture/test_palette.h"
#include "tools/texture/texture_files.h"

namespace oblong {

namespace {

/// Mean of the 2^level square at mip texel (x, y), in doubles.
std::array<double, 3> mean_of_square(const MipTexture& texture, const Palette& palette, int level, int x, int y) {
    const int size = 1 << level;
    std::array<double, 3> sum{};
    for (int i = 0; i < size * size; ++i) {
        const int at = (y * size + i / size) * texture.width + x * size + i % size;
        const Rgb8 colour = palette.colours[texture.mips[0][static_cast<std::size_t>(at)]];
        sum[0] += colour.red;
        sum[1] += colour.green;
        sum[2] += colour.blue;
    }
    for (double& part : sum) part /= size * size;
    return sum;
}

double distance(const std::array<double, 3>& mean, Rgb8 colour) {
    return std::hypot(mean[0] - colour.red, mean[1] - colour.green, mean[2] - colour.blue);
}

/// The smallest distance of any of the first `count` colours.
double best_distance(const std::array<double, 3>& mean, const Palette& palette, int count) {
    double best = std::numeric_limits<double>::max();
    for (int i = 0; i < count; ++i) best = std::min(best, distance(mean, palette.colours[static_cast<std::size_t>(i)]));
    return best;
}

TEST(Mipmaps, EachTexelIsAsNearToTheMeanAsAnyOrdinaryColour) {
    const Palette palette = test::scattered_palette();
    const MipTexture texture = make_mip_texture("any", 32, 16, test::scattered_texels(32 * 16, 224), palette);
    constexpr double kRoundingOfTheMean = 1.8;  // half a unit in each of three parts, twice
    for (int level = 1; level < 4; ++level) {
        const int width = 32 >> level, height = 16 >> level;
        const auto& mip = texture.mips[static_cast<std::size_t>(level)];
        ASSERT_EQ(mip.size(), static_cast<std::size_t>(width * height));
        for (int at = 0; at < width * height; ++at) {
            const auto mean = mean_of_square(texture, palette, level, at % width, at / width);
            const std::uint8_t index = mip[static_cast<std::size_t>(at)];
            EXPECT_LT(index, 224);
            EXPECT_LE(distance(mean, palette.colours[index]), best_distance(mean, palette, 224) + kRoundingOfTheMean);
        }
    }
}

TEST(Mipmaps, ATexelGlowsOnlyWhereHalfOfItsSquareDoes) {
    const Palette palette = test::scattered_palette();
    // Columns 0 to 3 glow (half of a square of 8x8), and of every other square of 8x8 only one texel.
    std::vector<std::uint8_t> texels(16 * 16, 5);
    for (std::size_t row = 0; row < 16; ++row) {
        for (std::size_t column = 0; column < 4; ++column) texels[row * 16 + column] = 240;
    }
    texels[15] = 240;
    const MipTexture texture = make_mip_texture("any", 16, 16, texels, palette);
    for (int level = 1; level < 4; ++level) {
        const int width = 16 >> level;
        for (int at = 0; at < width * width; ++at) {
            const bool is_in_band = at % width << level < 4;
            EXPECT_EQ(texture.mips[static_cast<std::size_t>(level)][static_cast<std::size_t>(at)] >= 224, is_in_band);
        }
    }
}

TEST(Mipmaps, AFlatTextureStaysWhatItIs) {
    const Palette palette = test::scattered_palette();
    for (const std::uint8_t index : {std::uint8_t{0}, std::uint8_t{77}, std::uint8_t{255}}) {
        const auto texture = make_mip_texture("flat", 16, 16, std::vector<std::uint8_t>(256, index), palette);
        for (const auto& mip : texture.mips) {
            for (const std::uint8_t texel : mip) EXPECT_EQ(texel, index);
        }
    }
}

TEST(RampSheet, EachCellIsOneShadeOfOneColour) {
    const Palette palette = test::scattered_palette();
    const Colormap colormap = make_colormap(palette);
    const PngImage sheet = decode_png(make_ramp_sheet(palette));
    ASSERT_EQ(sheet.width_px, 64 * 8);
    ASSERT_EQ(sheet.height_px, 256 * 4);
    for (std::size_t y = 0; y < 256 * 4; ++y)
        for (std::size_t x = 0; x < 64 * 8; ++x)
            ASSERT_EQ(sheet.indices[y * 512 + x], colormap.shades[x / 8][y / 4]) << x << ", " << y;
}

}  // namespace

}  // namespace oblong
