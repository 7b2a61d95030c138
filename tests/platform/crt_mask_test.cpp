#include "engine/platform/crt_mask.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace oblong {
namespace {

int channel(std::uint32_t argb, int of_three) {
    return static_cast<int>(argb >> (16 - 8 * of_three) & 255);
}

// The strongest channel of each row's first pixel.
std::vector<int> row_lights(std::int32_t height_px, std::int32_t rows) {
    std::vector<int> lights;
    for (const std::uint32_t pixel : make_crt_mask(1, height_px, rows)) lights.push_back(channel(pixel, 0));
    return lights;
}

TEST(CrtMask, RowsAreBrightInTheirMiddleByACosine) {
    constexpr int kHeight = 1200, kRows = 200;
    const std::vector<int> lights = row_lights(kHeight, kRows);
    ASSERT_EQ(lights.size(), 1200u);
    for (int y = 0; y < kHeight; ++y) {
        const double turn = (y + 0.5) * kRows / kHeight;
        const double light = 256 - 140 * (1 + std::cos(2 * 3.14159265358979 * turn)) / 2;
        EXPECT_NEAR(lights[static_cast<std::size_t>(y)], std::min(light, 255.0), 1.01) << y;
    }
}

TEST(CrtMask, RowsOfNoWholeNumberOfPixelsHaveOneBrightPlaceEach) {
    for (const int height : {600, 720, 1000, 1080}) {
        const std::vector<int> lights = row_lights(height, 200);
        int maxima = 0;
        for (std::size_t y = 1; y + 1 < lights.size(); ++y)
            maxima += lights[y] > lights[y - 1] && lights[y] >= lights[y + 1];
        EXPECT_EQ(maxima, 200) << height;
    }
}

TEST(CrtMask, RowsBelowTwoPixelsHaveNoLines) {
    for (const int height : {1, 199, 200, 400}) {
        const std::vector<int> lights = row_lights(height, 200);
        EXPECT_TRUE(std::all_of(lights.begin(), lights.end(), [](int light) { return light == 255; })) << height;
    }
}

TEST(CrtMask, ColumnsTakeTurnsAndNothingIsBlack) {
    const std::vector<std::uint32_t> mask = make_crt_mask(7, 960, 200);
    ASSERT_EQ(mask.size(), 7u * 960u);
    for (std::size_t at = 0; at < mask.size(); ++at) {
        const std::array<int, 3> light{channel(mask[at], 0), channel(mask[at], 1), channel(mask[at], 2)};
        EXPECT_EQ(mask[at] >> 24, 255u);
        EXPECT_EQ(std::max_element(light.begin(), light.end()) - light.begin(), static_cast<int>(at % 7 % 3));
        EXPECT_GT(*std::min_element(light.begin(), light.end()), 80);
    }
}

}  // namespace
}  // namespace oblong
