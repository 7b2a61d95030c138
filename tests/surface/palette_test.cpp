#include "engine/surface/palette.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "engine/base/input_error.h"
#include "engine/surface/colormap.h"
#include "tests/surface/true_oklab.h"

namespace oblong {

namespace {

TEST(Palette, TakesTriplesInOrder) {
    std::vector<std::uint8_t> bytes(768);
    bytes[0] = 1, bytes[1] = 2, bytes[2] = 3, bytes[767] = 4;
    const Palette palette = read_palette(bytes);
    EXPECT_EQ(palette.colours[0], (Rgb8{1, 2, 3}));
    EXPECT_EQ(palette.colours[255], (Rgb8{0, 0, 4}));
}

// Hard case P3: a shift alone would make the brightest colour 252.
TEST(Palette, SixBitsWidenToTheWholeRangeAndBack) {
    for (int v = 0; v < 64; ++v) {
        const std::uint8_t wide = widen_dac6(static_cast<std::uint8_t>(v));
        EXPECT_EQ(narrow_dac6(wide), v);
        EXPECT_LE(std::abs(wide * 63 - v * 255), 63) << "within one of " << v << " / 63";
    }
    EXPECT_EQ(widen_dac6(0), 0);
    EXPECT_EQ(widen_dac6(63), 255);
}

TEST(Palette, OtherSizesAreRefused) {
    for (const std::size_t size : {0u, 767u, 769u, 1024u})
        EXPECT_THROW(read_palette(std::vector<std::uint8_t>(size)), InputError) << size;
}

}  // namespace

}  // namespace oblong

namespace oblong::test {

namespace {

void expect_near(const FineRgb& colour) {
    constexpr double kOne_14 = 1 << 14, kBound = 1.0 / 4096;
    const Oklab found = oklab_of(colour);
    const TrueOklab truth = true_oklab(colour.red_8 / 256.0, colour.green_8 / 256.0, colour.blue_8 / 256.0);
    const auto name = [&] {
        return std::to_string(colour.red_8) + " " + std::to_string(colour.green_8) + " " +
               std::to_string(colour.blue_8);
    };
    ASSERT_NEAR(found.lightness_14 / kOne_14, truth[0], kBound) << name();
    ASSERT_NEAR(found.green_red_14 / kOne_14, truth[1], kBound) << name();
    ASSERT_NEAR(found.blue_yellow_14 / kOne_14, truth[2], kBound) << name();
}

TEST(Oklab, AgreesWithItsFormulasInDoubles) {
    for (std::int32_t red = 0; red <= 255; red += 15)
        for (std::int32_t green = 0; green <= 255; green += 15)
            for (std::int32_t blue = 0; blue <= 255; blue += 15) expect_near({red * 256, green * 256, blue * 256});
}

TEST(Oklab, SeesTheFractionsOfDarkColours) {
    for (std::int32_t red_8 = 0; red_8 < 16 * 256; red_8 += 203)
        for (std::int32_t green_8 = 0; green_8 < 16 * 256; green_8 += 317)
            for (std::int32_t blue_8 = 0; blue_8 < 16 * 256; blue_8 += 251) expect_near({red_8, green_8, blue_8});
}

TEST(Oklab, BlackIsZeroAndGreysHaveNoHue) {
    EXPECT_EQ(oklab_of({}).lightness_14, 0);
    for (std::int32_t grey_8 = 0; grey_8 <= 255 * 256; grey_8 += 64) {
        EXPECT_NEAR(oklab_of({grey_8, grey_8, grey_8}).green_red_14, 0, 1) << grey_8;
        EXPECT_NEAR(oklab_of({grey_8, grey_8, grey_8}).blue_yellow_14, 0, 1) << grey_8;
    }
}

}  // namespace

}  // namespace oblong::test
