#include "engine/surface/palette.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "engine/base/input_error.h"

namespace oblong {
namespace {

TEST(Palette, TakesTriplesInOrder) {
    std::vector<std::uint8_t> bytes(768);
    bytes[0] = 1, bytes[1] = 2, bytes[2] = 3, bytes[767] = 4;
    const Palette palette = read_palette(bytes);
    EXPECT_EQ(palette.colours[0], (Rgb8{1, 2, 3}));
    EXPECT_EQ(palette.colours[255], (Rgb8{0, 0, 4}));
}

TEST(Palette, OtherSizesAreRefused) {
    for (const std::size_t size : {0u, 767u, 769u, 1024u})
        EXPECT_THROW(read_palette(std::vector<std::uint8_t>(size)), InputError) << size;
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

TEST(Palette, ShownTwiceIsShownOnce) {
    Palette palette;
    for (std::size_t i = 0; i < 256; ++i) {
        const auto c = static_cast<std::uint8_t>(i);
        palette.colours[i] = {c, static_cast<std::uint8_t>(255 - c), static_cast<std::uint8_t>(c * 7)};
    }
    const Palette once = as_shown_by_dac6(palette);
    EXPECT_EQ(once.colours[129].red, 32 * 4 + 2);
    EXPECT_EQ(as_shown_by_dac6(once).colours, once.colours);
}

}  // namespace
}  // namespace oblong
