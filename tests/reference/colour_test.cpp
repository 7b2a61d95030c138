#include "engine/reference/colour.h"

#include <gtest/gtest.h>

#include "tests/reference/made_level.h"

namespace oblong::reference::colour_test {
namespace {

using namespace test;

/// Palette entry i is (i, 2 i mod 256, 100).
Palette make_test_palette() {
    Palette palette;
    for (int i = 0; i < 256; ++i) palette[static_cast<std::size_t>(i)] = {double(i), double(i * 2 % 256), 100};
    return palette;
}

/// A face of 3 x 2 light samples from texel (-16, 32) on.
struct LitFace {
    Level level = make_level();
    Face face;

    LitFace() {
        level.lighting = {0, 64, 128, 32, 96, 255};
        face.first_u = -16, face.first_v = 32;
        face.light_columns = 3, face.light_rows = 2;
        face.light_offset = 0;
        face.styles = {0, 255, 255, 255};
    }
    double at(double u, double v) const { return light_at(level, face, u, v).green; }
};

TEST(ReferenceLight, IsInterpolatedBetweenSamplesAndTheLastOneBeyond) {
    const LitFace lit;
    for (const auto& [u, v, light] : {std::array{-8.0, 32.0, 0.25},
                                      {-16, 40, 0.125},
                                      {-8, 40, (0 + 0.5 + 0.25 + 0.75) / 4},
                                      {-12, 32, 0.125},
                                      {8, 48, (96 + 255) / 256.0},
                                      // Beyond the samples it is the last one's.
                                      {-100, 0, 0},
                                      {100, 32, 1},
                                      {0, 100, 0.75}})
        EXPECT_DOUBLE_EQ(lit.at(u, v), light) << u << ", " << v;
}

TEST(ReferenceLight, StylesAddUp) {
    LitFace lit;
    lit.level.lighting = {10, 10, 10, 10, 10, 10, 22, 22, 22, 22, 22, 22};
    lit.face.styles = {0, 3, 255, 255};
    EXPECT_DOUBLE_EQ(lit.at(0, 40), 0.25);
}

TEST(ReferenceLight, IsAtMostTwiceFull) {
    LitFace lit;
    lit.level.lighting = {200, 0, 0, 0, 0, 0, 200, 0, 0, 0, 0, 0};
    lit.face.styles = {0, 3, 255, 255};
    EXPECT_DOUBLE_EQ(lit.at(-16, 32), 2);
    EXPECT_DOUBLE_EQ(lit.at(-8, 32), 1);  // samples are limited first: (2 + 0) / 2
}

TEST(ReferenceLight, WithoutALightmapFacesAreDarkAndLevelsBright) {
    LitFace lit;
    lit.face.light_offset = -1;
    EXPECT_DOUBLE_EQ(lit.at(0, 40), 0);
    lit.level.lighting.clear();
    EXPECT_DOUBLE_EQ(lit.at(0, 40), 1);
}

TEST(ReferenceColour, IsThatOfTheWrappedTexelTimesTheLight) {
    LitFace lit;
    lit.level.lighting[5] = 128;
    Texture& texture = lit.level.textures[0];
    for (int i = 0; i < 256; ++i) texture.texels[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(i);
    const auto colour = [&](double u, double v) { return true_colour(lit.level, lit.face, u, v, make_test_palette()); };
    EXPECT_DOUBLE_EQ(colour(0, 32).red, 0 * 0.5);
    EXPECT_DOUBLE_EQ(colour(16.5, 33.9).red, 16);  // full light; texel (0, 1)
    EXPECT_DOUBLE_EQ(colour(16.5, 33.9).green, 32);
    EXPECT_DOUBLE_EQ(colour(-0.5, 32).red, 15 * 31.0 / 64);    // texel (15, 0), light just before the sample of 0.5
    EXPECT_DOUBLE_EQ(colour(15.5, -0.5).red, 255);             // texel (15, 15): glows
    EXPECT_DOUBLE_EQ(colour(-16, 14.5).red, 224);              // the first that does
    EXPECT_DOUBLE_EQ(colour(-1, 13.5).blue, 100 * 15.0 / 32);  // 223: the last that does not
    lit.level.lighting.assign(6, 192);
    EXPECT_DOUBLE_EQ(colour(-14.5, 32).green, 2 * 1.5);  // texel (1, 0)
    EXPECT_DOUBLE_EQ(colour(-1, 13.5).red, 255);         // 223 times 1.5 is more
    EXPECT_DOUBLE_EQ(colour(-1, 13.5).blue, 150);
    lit.face.material = Material::Liquid;
    EXPECT_DOUBLE_EQ(colour(-1, 13.5).blue, 100);
}

/// White and black squares of one texel.
Level make_checkerboard_level() {
    Level level = make_level();
    for (std::size_t i = 0; i < 256; ++i) level.textures[0].texels[i] = (i / 16 + i) % 2 == 0 ? 200 : 0;
    return level;
}

TEST(ReferenceColours, SamplesOfAnEdgePixelAreThePartCovered) {
    Level level = make_level();
    level.textures[0].texels.assign(256, 200);
    add_rectangle(level, 0, 0, 100.75, 200, 160);
    level.textures.push_back({"black", 16, 16, std::vector<std::uint8_t>(256, 0)});
    level.texinfos.push_back(level.texinfos[0]);
    level.texinfos[1].texture = 1;
    add_rectangle(level, 100.75, 0, 320, 200, 160).texinfo = 1;
    const auto red = [&](int samples, std::size_t column) {
        return draw_colours(level, {}, make_plain_view(), make_test_palette(), samples)[320 * 50 + column].colour.red;
    };
    EXPECT_DOUBLE_EQ(red(1, 100), 200);
    EXPECT_DOUBLE_EQ(red(4, 100), 150);
    EXPECT_DOUBLE_EQ(red(4, 99), 200);
    EXPECT_DOUBLE_EQ(red(4, 101), 0);
}

TEST(ReferenceColours, MoreSamplesComeNearerToTheMean) {
    Level level = make_checkerboard_level();
    add_rectangle(level, 0, 0, 320, 200, 160 * 2.3);  // 2.3 texels a pixel
    const auto rms = [&](int samples) {
        double sum = 0;
        const auto picture = draw_colours(level, {}, make_plain_view(), make_test_palette(), samples);
        for (const ColourPixel& pixel : picture) sum += (pixel.colour.red - 100) * (pixel.colour.red - 100);
        return std::sqrt(sum / static_cast<double>(picture.size()));
    };
    EXPECT_DOUBLE_EQ(rms(1), 100);
    EXPECT_LT(rms(4), 15);
    EXPECT_LT(rms(8), rms(4));
}

TEST(ReferenceColours, SkyAndPixelsWithoutAFaceAreExcluded) {
    Level level = make_level();
    add_rectangle(level, 10.5, 0, 20, 200);
    add_rectangle(level, 20, 0, 30, 200).material = Material::Sky;
    const auto picture = draw_colours(level, {}, make_plain_view(), make_test_palette(), 2);
    EXPECT_TRUE(picture[9].is_excluded);
    EXPECT_TRUE(picture[10].is_excluded);  // half of it
    EXPECT_FALSE(picture[11].is_excluded);
    EXPECT_TRUE(picture[25].is_excluded);
}

}  // namespace
}  // namespace oblong::reference::colour_test
