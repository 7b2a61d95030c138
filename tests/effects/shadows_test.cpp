// Shadows against the disc that they stand for, point by point on the floor.
#include "engine/effects/shadows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/views.h"

namespace oblong::test {

namespace {

/// A level of nothing but a plane: z = slope_x * x, in the world's units.
Level level_of_slope(double slope_x) {
    Level level;
    const double length = std::hypot(slope_x, 1);
    LevelPlane plane;
    plane.normal = {fixed_of<Unit>(-slope_x / length), {}, fixed_of<Unit>(1 / length)};
    level.planes.push_back(plane);
    return level;
}

std::vector<std::uint8_t> one_brighter() {
    std::vector<std::uint8_t> row(256);
    for (std::size_t i = 0; i < 256; ++i) row[i] = static_cast<std::uint8_t>(i + 1);
    return row;
}

constexpr std::int32_t kWhole = 256;

}  // namespace

TEST(Shadows, CoverTheirDiscOnALevelAndOnASlopedFloor) {
    for (const double slope : {0., 0.5}) {
        const Level level = level_of_slope(slope);
        const ViewContext view = view_from(point_at(-100, 0, 90), {}, degrees_to_angle(Degrees::from_int(35)));
        const Shadow shadow{{PlaneIndex(0), {}}, World::from_int(40)};
        ShadowScratch scratch(200);
        ASSERT_TRUE(scan_shadow(shadow, kWhole, level, view, scratch));
        std::vector<std::uint8_t> pixels(320 * 200);
        darken_spans(all_rows(), scratch.rows, one_brighter().data(), {pixels.data(), 320, 200, 320});
        const TrueCamera camera({view.eye, {}, degrees_to_angle(Degrees::from_int(35)), {}});
        int inside = 0;
        for (std::int32_t y = 0; y < 200; ++y)
            for (std::int32_t x = 0; x < 320; ++x) {
                const Point ray = camera.through_pixel(x, y);
                // -100 + t ray.x, t ray.y, 90 + t ray.z lies on z = slope x
                const double t = (90 + slope * 100) / (slope * ray.x - ray.z);
                const double radius = std::hypot(-100 + t * ray.x, t * ray.y);
                if (t > 0 && radius < 40 * std::cos(M_PI / 16) - 0.5) {
                    ASSERT_EQ(pixels[as_size(y * 320 + x)], 1) << x << ", " << y;
                    ++inside;
                }
                if (t < 0 || radius > 40.5) {
                    ASSERT_EQ(pixels[as_size(y * 320 + x)], 0) << x << ", " << y;
                }
            }
        EXPECT_GT(inside, 1000);
    }
}

TEST(Shadows, FallOnNothingButTheSpansOfTheirPlane) {
    const Level level = level_of_slope(0);
    const ViewContext view = view_from(point_at(-100, 0, 90), {}, degrees_to_angle(Degrees::from_int(35)));
    ShadowScratch scratch(200);
    ASSERT_TRUE(scan_shadow({{PlaneIndex(0), {}}, World::from_int(40)}, kWhole, level, view, scratch));
    const std::int32_t y = (scratch.rows.first + scratch.rows.end) / 2;
    const std::int32_t left = scratch.rows.left[as_size(y)], right = scratch.rows.right[as_size(y)];
    std::vector<std::uint8_t> pixels(320 * 200);
    const std::vector<Span> spans{{y, 0, left + 3}, {y, right - 2, 320}, {0, 0, 320}, {199, 0, 320}};
    darken_spans(spans, scratch.rows, one_brighter().data(), {pixels.data(), 320, 200, 320});
    for (std::int32_t x = 0; x < 320; ++x) {
        const bool is_dark = (x >= left && x < left + 3) || (x >= right - 2 && x < right);
        EXPECT_EQ(pixels[as_size(y * 320 + x)], is_dark ? 1 : 0) << x;
    }
    EXPECT_EQ(std::count(pixels.begin(), pixels.end(), 1), 5);
}

TEST(Shadows, BecomeSmallerWithHeightAndEndAt128Units) {
    const Floor floor{PlaneIndex(0), point_at(5, 6, 7)};
    const auto radius_at = [&](std::int32_t height) {
        return make_shadow(floor, point_at(5, 6, 7 + height), World::from_int(60)).radius;
    };
    EXPECT_EQ(radius_at(0), World::from_int(60));
    EXPECT_EQ(radius_at(64), World::from_int(30));
    EXPECT_EQ(radius_at(128), World{});
    EXPECT_EQ(radius_at(1000), World{});
    EXPECT_EQ(radius_at(-10), World::from_int(60)) << "rounding may put it below";
    ShadowScratch scratch(200);
    EXPECT_FALSE(scan_shadow(make_shadow(floor, point_at(5, 6, 200), World::from_int(60)), kWhole, level_of_slope(0),
                             view_from({}), scratch));
}

TEST(Shadows, OutOfViewHaveNoPixels) {
    ShadowScratch scratch(200);
    const Shadow shadow{{PlaneIndex(0), point_at(-200, 0, -50)}, World::from_int(40)};
    EXPECT_FALSE(scan_shadow(shadow, kWhole, level_of_slope(0), view_from({}), scratch));
}

}  // namespace oblong::test
