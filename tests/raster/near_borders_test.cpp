// Which pixels of a line are near the border of a texel, by eight against one by one.
#include <gtest/gtest.h>

#include <random>

#include "engine/raster/kernels/kernels.h"

namespace oblong::test {

TEST(NearBorders, EightAtATimeFindWhatOneByOneFinds) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 20000; ++trial) {
        const auto any = [&random] { return static_cast<std::uint32_t>(random()); };
        const auto step = [&] { return static_cast<std::int32_t>(any()) >> any() % 31; };
        const TexelBlock block{0, static_cast<std::int32_t>(1 + any() % 64), any(), any(), step(), step()};
        const std::uint32_t error_16 = 1 + any() % 16383;
        ASSERT_EQ(pixels_near_borders(block, error_16), pixels_near_borders_plain(block, error_16)) << trial;
    }
}

TEST(NearBorders, AreNearByTheErrorAndNoFarther) {
    const auto is_near = [](std::uint32_t u_16) {
        return pixels_near_borders_plain({0, 1, u_16, 0x58000, 0, 0}, 100) != 0;
    };
    EXPECT_FALSE(is_near(0x2ff9b));  // 101 units before
    EXPECT_TRUE(is_near(0x2ff9c));
    EXPECT_TRUE(is_near(0x30000));
    EXPECT_TRUE(is_near(0x30063));
    EXPECT_FALSE(is_near(0x30064));  // 100 behind: an error of 100 leads to the border, which is its own texel's
}

}  // namespace oblong::test
