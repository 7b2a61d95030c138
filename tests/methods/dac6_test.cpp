#include "engine/methods/dac6.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace oblong {
namespace {

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
