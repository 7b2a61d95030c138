#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/math/vec.h"
#include "engine/methods/lines.h"
#include "engine/methods/polygons.h"
#include "engine/raster/scan.h"
#include "engine/reference/view.h"
#include "tests/hard_cases/hard_case.h"

namespace oblong::test {
namespace {

using reference::Vec;

/// Left-handed axes, y up: yaw turns forward toward right, then pitch turns forward toward up, then roll turns right
/// toward up. Angles in 1/65536 of a turn.
reference::Axes turned_axes(double yaw, double pitch, double roll) {
    const double a = yaw * std::numbers::pi / 32768, b = pitch * std::numbers::pi / 32768,
                 g = roll * std::numbers::pi / 32768;
    const Vec level_forward{std::sin(a), 0, std::cos(a)}, level_right{std::cos(a), 0, -std::sin(a)}, vertical{0, 1, 0};
    const Vec forward = level_forward * std::cos(b) + vertical * std::sin(b);
    const Vec up = vertical * std::cos(b) - level_forward * std::sin(b);
    return {level_right * std::cos(g) + up * std::sin(g), up * std::cos(g) - level_right * std::sin(g), forward};
}

TEST(HardCaseV1, OppositeCornersOfTheWorld) {
    std::mt19937 random(1);
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        const double sx = i & 1 ? 32767 : -32767, sy = i & 2 ? 32767 : -32767, sz = i & 4 ? 32767 : -32767;
        const int yaw = random_integer(random, 0, 65535), pitch = random_integer(random, 0, 65535),
                  roll = random_integer(random, 0, 65535);
        const auto found = ask_numbers(join("view 320 200 4 3 90", sx, sy, sz, yaw, pitch, roll, -sx, -sy, -sz));
        const Vec view = reference::to_view({-sx, -sy, -sz}, {sx, sy, sz}, turned_axes(yaw, pitch, roll));
        if (view.z < 1) continue;
        const auto expected = reference::project(view, kProjection);
        ASSERT_EQ(found.size(), 3u);
        worst = std::max({worst, std::abs(found[0] - expected.x), std::abs(found[1] - expected.y)});
        EXPECT_NEAR(found[2], view.z, 1e-6);
    }
    EXPECT_LE(worst, 1.0 / 200);
    RecordProperty("worst_error_px", std::to_string(worst));
}

TEST(HardCaseV3, PointsInOrBehindTheEyesPlane) {
    for (const char* z : {"0", "-0.00390625", "-1", "-32767"})
        EXPECT_EQ(ask(std::string("project 320 200 4 3 90 5 -5 ") + z), "behind");
    EXPECT_EQ(ask("project 320 200 4 3 90 0 0 0.00390625"), "160 100");
}

TEST(HardCaseV4, FieldsOfViewOf1And179Degrees) {
    const auto narrow = ask_numbers("project 320 200 4 3 1 1 1 4"), wide = ask_numbers("project 320 200 4 3 179 1 1 4");
    EXPECT_NEAR(narrow.at(0), 4743.546, 0.004);
    EXPECT_NEAR(narrow.at(1), -3719.622, 0.004);
    EXPECT_NEAR(wide.at(0), 160.3491, 0.004);
    EXPECT_NEAR(wide.at(1), 99.7091, 0.004);
}

TEST(HardCaseV5, CornersOfTheViewLandOnThoseOfTheScreen) {
    EXPECT_EQ(ask("project 320 200 4 3 90 -4 3 4"), "0 0");
    EXPECT_EQ(ask("project 320 200 4 3 90 4 -3 4"), "320 200");
}

TEST(HardCaseV6, SpheresAreRoundOnTheDisplay) {
    // The outline of a sphere straight ahead is the circle that its tangents through the eye touch.
    const double distance = 64, radius = 24;
    const double ring_z = distance - radius * radius / distance;
    const double ring = radius * std::sqrt(distance * distance - radius * radius) / distance;
    double left = 320, right = 0, top = 200, bottom = 0;
    for (int step = 0; step < 360; ++step) {
        const double angle = step * std::numbers::pi / 180;
        const auto at = ask_numbers(join("project 320 200 4 3 90", snapped(ring * std::cos(angle)),
                                         snapped(ring * std::sin(angle)), snapped(ring_z)));
        left = std::min(left, at.at(0));
        right = std::max(right, at.at(0));
        top = std::min(top, at.at(1));
        bottom = std::max(bottom, at.at(1));
    }
    EXPECT_NEAR((bottom - top) * 1.2, right - left, 0.5);  // 5 rows are as long on the display as 6 columns
}

TEST(HardCaseV7, TheLabsCubeShrinksByDepthAndDoesNotSlide) {
    // 100 pixels a unit at distance 4, mirrored: x of the cube grows to the left.
    const std::string mode = "project 200 200 1 1 28.072486935852957";  // 2 arctan(1/4)
    for (const int x : {0, 1})
        for (const int y : {0, 1})
            for (const int z : {0, 1}) {
                const int first = 150 - 10 * z, size = 100 - 20 * z;
                EXPECT_EQ(ask(join(mode, 0.5 - x, y - 0.5, 4 + z)), join(first - size * x, first - size * y));
            }
}

TEST(HardCaseV8, ScreenAreaTellsTheSideThatAFaceShows) {
    std::mt19937 random(8);
    int compared = 0, wrong_by_normal = 0;
    for (int i = 0; i < 5000; ++i) {
        std::array<Vec, 3> corners;
        std::array<ScreenVertex, 3> screen;
        for (std::size_t k = 0; k < 3; ++k) {
            const double z = snapped(random_between(random, 4, 400));
            corners[k] = {snapped(random_between(random, -z, z)), snapped(random_between(random, -z, z)), z};
            const auto at = ask_numbers(join("project 320 200 4 3 90", corners[k].x, corners[k].y, z));
            screen[k] = {Screen::from_raw(static_cast<std::int32_t>(at.at(0) * 256)),
                         Screen::from_raw(static_cast<std::int32_t>(at.at(1) * 256))};
        }
        const ScreenArea area = doubled_area(screen);
        if (absolute(area) < ScreenArea::from_int(1)) continue;
        // Clockwise as seen, in left-handed axes: the eye lies on the side that the normal points away from.
        const Vec normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
        ASSERT_EQ(area > ScreenArea{}, dot(normal, corners[0]) < 0) << i;
        // The engine's own answer, by the plane that its world would have.
        const std::array world{to_world(corners[0]), to_world(corners[1]), to_world(corners[2])};
        const Plane plane = plane_through(world[0], normalised(cross(world[1] - world[0], world[2] - world[0])));
        ASSERT_EQ(area > ScreenArea{}, distance_to_plane({}, plane) > PlaneDistance{}) << i;
        ASSERT_EQ(area < ScreenArea{}, faces_away(world[0], plane.normal, {})) << i;
        wrong_by_normal += normal_points_away(plane.normal, {{}, {}, Unit::from_int(1)}) != (area < ScreenArea{});
        ++compared;
    }
    EXPECT_GT(compared, 4000);
    EXPECT_GT(wrong_by_normal, 100);
    EXPECT_LT(wrong_by_normal, compared / 2);
}

TEST(HardCaseV10, FarOffTheScreenNothingWraps) {
    for (const double x : {-32767.0, -1.0, 1.0, 32767.0})
        for (const double z : {0.00390625, 0.5, 1.0, 32767.0}) {
            const auto found = ask_numbers(join("project 320 200 4 3 90", x, -x, z));
            const auto expected = reference::project({x, -x, z}, kProjection);
            EXPECT_NEAR(found.at(0), expected.x, 0.005) << x << ' ' << z;
            EXPECT_NEAR(found.at(1), expected.y, 0.005) << x << ' ' << z;
        }
}

}  // namespace
}  // namespace oblong::test
