#include <gtest/gtest.h>

#include "engine/reference/view.h"
#include "tests/reference/made_level.h"

// Where the plane shows a texel, by its closed forms: tests/measure/texel_error_test.cpp.
namespace oblong::reference::plane_view_test {
namespace {

using namespace test;

/// A floor whose height at x = 100 is this, at -100 it is -64; u is x, v is 7 - y.
Level floor_rising_to(double height) {
    Level level = make_level();
    level.texinfos[0] = {{1, 0, 0}, {0, -1, 0}, 0, 7, 0, false};
    add_face(level, {{-100, 100, -64}, {100, 100, height}, {100, -100, height}, {-100, -100, -64}});
    return level;
}

TEST(PlaneView, TexelsBehindTheEyeHaveNoPlace) {
    const Level level = floor_rising_to(-64);
    const PlaneView view(level, level.faces[0], {}, make_camera(make_plain_view()));
    EXPECT_FALSE(view.place_of(-50, 7));
    ASSERT_TRUE(view.place_of(64, 7));
    EXPECT_NEAR(view.place_of(64, 7)->x, 160, 1e-9);
    EXPECT_NEAR(view.place_of(64, 7)->y, 260, 1e-9);  // 45 degrees down
}

TEST(PlaneView, AxesAcrossThePlaneHaveNoPlaces) {
    Level level = floor_rising_to(-30);
    level.texinfos[0].s = level.faces[0].plane.normal * 0.7;
    const PlaneView view(level, level.faces[0], {}, make_camera(make_plain_view()));
    for (const double u : {-9, 0, 5}) EXPECT_FALSE(view.place_of(u, 7)) << u;
}

}  // namespace
}  // namespace oblong::reference::plane_view_test
