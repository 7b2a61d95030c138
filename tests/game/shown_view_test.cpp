#include "game/view/shown_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "engine/level/bsp_read.h"
#include "game/program/view_options.h"
#include "tests/support/folders.h"

namespace oblong::test::shown_view_test {
namespace {

Level demo_level() {
    return read_bsp(test::read_file_bytes(std::filesystem::path(test::build_folder()) / "assets" / "demo.bsp"));
}

/// Before the sphere of the second room, 300 units from its middle.
Camera camera_before_sphere() {
    Camera camera;
    camera.eye = {World::from_int(-112), World::from_int(52), World::from_int(128)};
    camera.yaw = kQuarterTurn;
    return camera;
}

/// The columns between two places left and right of the camera's way north.
double size_at(const ViewSpec& spec, int y) {
    const ViewContext view = make_view_context(spec, {});
    const auto column = [&](int x) {
        const Vec3<World> place{World::from_int(x), World::from_int(y), World::from_int(128)};
        return std::ldexp(project(to_view(place, view), view.projection).x.raw, -8);
    };
    return column(-92) - column(-132);
}

TEST(ShownView, IsTheCamerasUntilAKeyIsPressed) {
    EXPECT_FALSE(other_view(false, 0, camera_before_sphere(), demo_level()));
}

TEST(ShownView, IsIsometricAroundThePlayerWithoutWhatIsAbove) {
    const auto view = other_view(true, 30, camera_before_sphere(), demo_level());
    ASSERT_TRUE(view);
    EXPECT_TRUE(view->is_parallel);
    EXPECT_EQ(view->eye, camera_before_sphere().eye);
    ASSERT_EQ(view->cuts.size(), 1u);
    EXPECT_EQ(view->cuts[0].normal.z, Unit::from_int(-1));
    EXPECT_EQ(view->cuts[0].distance, PlaneDistance::from_int(-168));
}

// The sphere's front is about 212 units ahead: what is there keeps its size, and what is behind it grows as the field
// of view shrinks.
TEST(ShownView, KeepsTheSizeOfWhatIsInTheMiddleWhileItZooms) {
    const Level level = demo_level();
    const Camera camera = camera_before_sphere();
    double far_before = 0;
    for (const std::int32_t degrees : {120, 60, 30, 10}) {
        const auto view = other_view(false, degrees, camera, level);
        ASSERT_TRUE(view);
        EXPECT_EQ(view->cuts.empty(), degrees > 90);
        double least = 1e9;
        for (int y = 100; y < 352; ++y)
            least = std::min(least, std::abs(size_at(*view, y) - size_at(first_person_view(camera), y)));
        EXPECT_LT(least, 0.3) << degrees;
        const double far = size_at(*view, 900);
        EXPECT_GT(far, far_before);
        far_before = far;
    }
}

TEST(ShownView, ZoomsBetweenItsLimitsAndIsOffAt90Degrees) {
    ViewOptions options;
    const auto press = [&](Action command) { return apply(command, options, {1600, 1200}); };
    EXPECT_EQ(press(Action::ZoomIn), "{zoom-in} {zoom-out} Zoom against dolly: 80 degrees");
    EXPECT_EQ(press(Action::ZoomOut), "{zoom-in} {zoom-out} Zoom against dolly: off");
    EXPECT_EQ(options.zoom_degrees, 0);
    for (int i = 0; i < 20; ++i) press(Action::ZoomOut);
    EXPECT_EQ(options.zoom_degrees, 120);
    for (int i = 0; i < 20; ++i) press(Action::ZoomIn);
    EXPECT_EQ(options.zoom_degrees, 10);
}

std::string press(Action command, ViewOptions& options) {
    return apply(command, options, {1600, 1200});
}

TEST(ViewOptions, KeysStepThroughBrightnessUpToItsLimits) {
    ViewOptions options;
    press(Action::Brighter, options);
    EXPECT_EQ(options.preferences.light().brightness_100, 140);
    press(Action::Darker, options);
    EXPECT_EQ(options.preferences.light().brightness_100, 100);
    options.preferences.set_light({150});  // by --brightness, between two steps
    press(Action::Darker, options);
    EXPECT_EQ(options.preferences.light().brightness_100, 140);
    for (int i = 0; i < 20; ++i) press(Action::Brighter, options);
    EXPECT_EQ(settings_of(options.preferences).brightness_100, 800);
    for (int i = 0; i < 20; ++i) press(Action::Darker, options);
    EXPECT_EQ(settings_of(options.preferences).brightness_100, 25);
}

TEST(ViewOptions, TorchAndTubeAreOffUntilTheirKeysArePressed) {
    ViewOptions options;
    EXPECT_FALSE(options.has_torch || options.preferences.has_crt_look);
    for (const bool is_on : {true, false}) {
        EXPECT_FALSE(press(Action::Torch, options).empty());
        EXPECT_FALSE(press(Action::CrtLook, options).empty());
        EXPECT_EQ(options.has_torch, is_on);
        EXPECT_EQ(options.preferences.has_crt_look, is_on);
    }
}

TEST(ViewOptions, MapAndEdgesGoThroughTheirViewsAndOffAgain) {
    ViewOptions options;
    for (const MapView expected : {MapView::PlayerUp, MapView::NorthUp, MapView::Off}) {
        EXPECT_FALSE(press(Action::Automap, options).empty());
        EXPECT_EQ(options.map, expected);
    }
    for (const Wireframe expected : {Wireframe::Over, Wireframe::Alone, Wireframe::Off}) {
        EXPECT_FALSE(press(Action::Wireframe, options).empty());
        EXPECT_EQ(options.wireframe, expected);
    }
}

TEST(ViewOptions, FlashesReachTheFrame) {
    ViewOptions options;
    EXPECT_EQ(settings_of(options.preferences).flashes, Flashes::Full);
    options.preferences.flashes = Flashes::Off;
    EXPECT_EQ(settings_of(options.preferences).flashes, Flashes::Off);
}

}  // namespace
}  // namespace oblong::test::shown_view_test
