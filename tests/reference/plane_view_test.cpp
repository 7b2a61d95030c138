#include <gtest/gtest.h>

#include <random>

#include "tests/reference/made_level.h"
#include "tests/support/random.h"
#include "tools/reference/view.h"

namespace oblong::reference::plane_view_test {
namespace {

using namespace test;

/// A plane through the middle of the screen at a depth of 20 to 1000, inclined by up to some 80 degrees, with skewed
/// axes.
struct RandomPlane {
    Level level = make_level();
    View view;
    Vec offset;

    explicit RandomPlane(std::mt19937& random) {
        const auto any = [&](double size) { return random_between(random, -size, size); };
        const auto any_vec = [&](double size) { return Vec{any(size), any(size), any(size)}; };
        view = {any_vec(4000), any(65536), any(65536), any(65536)};
        const Axes axes = make_camera(view).axes;
        offset = any_vec(100);
        Face face;
        face.plane.normal = axes.right * any(4) + axes.up * any(4) - axes.forward;
        face.plane.offset = dot(face.plane.normal, view.eye + axes.forward * random_between(random, 20, 1000) - offset);
        level.faces = {face};
        const Vec s = cross(face.plane.normal, axes.up), t = cross(face.plane.normal, s);
        level.texinfos[0] = {
            s * any(1) + t + face.plane.normal * any(1), s + t * any(0.3), any(500), any(500), 0, false};
    }
    PlaneView make() const { return {level, level.faces[0], offset, make_camera(view)}; }
};

TEST(PlaneView, TheTexelIsThatOfThePointOnThePlane) {
    std::mt19937 random(1);
    for (int i = 0; i < 500; ++i) {
        const RandomPlane plane(random);
        const Camera camera = make_camera(plane.view);
        const ScreenPoint at{random_between(random, 150, 170), random_between(random, 90, 110)};
        const Texel texel = plane.make().texel_at(at);
        if (texel.inverse_z < 1e-4) continue;
        const Vec view_point =
            Vec{(at.x - 160) / camera.projection.multiplier_x, -(at.y - 100) / camera.projection.multiplier_y, 1} *
            (1 / texel.inverse_z);
        const Vec point = camera.eye + camera.axes.right * view_point.x + camera.axes.up * view_point.y +
                          camera.axes.forward * view_point.z - plane.offset;
        const Plane& expected = plane.level.faces[0].plane;
        EXPECT_NEAR(dot(expected.normal, point), expected.offset, 1e-6);
        const TexInfo& texinfo = plane.level.texinfos[0];
        EXPECT_NEAR(texel.u, dot(texinfo.s, point) + texinfo.s_offset, 1e-6);
        EXPECT_NEAR(texel.v, dot(texinfo.t, point) + texinfo.t_offset, 1e-6);
    }
}

TEST(PlaneView, PlaceOfIsTheInverseOfTexelAt) {
    std::mt19937 random(2);
    int compared = 0;
    for (int i = 0; i < 2000; ++i) {
        const RandomPlane plane(random);
        const PlaneView view = plane.make();
        const ScreenPoint at{random_between(random, 0, 320), random_between(random, 0, 200)};
        const Texel texel = view.texel_at(at);
        if (texel.inverse_z < 1e-4) continue;
        const auto place = view.place_of(texel.u, texel.v);
        ASSERT_TRUE(place);
        EXPECT_NEAR(place->x, at.x, 1e-9);
        EXPECT_NEAR(place->y, at.y, 1e-9);
        ++compared;
    }
    EXPECT_GT(compared, 1000);
}

TEST(PlaneView, TexelsBehindTheEyeHaveNoPlace) {
    Level level = make_level();
    level.texinfos[0] = {{1, 0, 0}, {0, -1, 0}, 0, 0, 0, false};
    add_face(level, {{-100, 100, -64}, {100, 100, -64}, {100, -100, -64}, {-100, -100, -64}});
    const PlaneView view(level, level.faces[0], {}, make_camera(make_plain_view()));
    EXPECT_FALSE(view.place_of(-50, 0));
    ASSERT_TRUE(view.place_of(64, 0));
    EXPECT_NEAR(view.place_of(64, 0)->x, 160, 1e-9);
    EXPECT_NEAR(view.place_of(64, 0)->y, 260, 1e-9);  // 45 degrees down
}

TEST(PlaneView, AxesAcrossThePlaneHaveNoPlaces) {
    std::mt19937 random(5);
    for (int i = 0; i < 100; ++i) {
        RandomPlane plane(random);
        plane.level.texinfos[0].s = plane.level.faces[0].plane.normal * 0.7;
        EXPECT_FALSE(plane.make().place_of(random_between(random, -9, 9), random_between(random, -9, 9))) << i;
    }
}

}  // namespace
}  // namespace oblong::reference::plane_view_test
