#include "game/view/shown_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "engine/level/bsp_read.h"
#include "engine/visibility/eye.h"
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
    EXPECT_FALSE(other_view(false, 0, camera_before_sphere(), {}, demo_level()));
}

TEST(ShownView, IsIsometricAroundThePlayerWithoutWhatIsAbove) {
    const auto view = other_view(true, 30, camera_before_sphere(), {}, demo_level());
    ASSERT_TRUE(view);
    EXPECT_TRUE(view->is_parallel);
    EXPECT_EQ(view->eye, camera_before_sphere().eye);
    ASSERT_EQ(view->cuts.size(), 1u);
    EXPECT_EQ(view->cuts[0].normal.z, Unit::from_int(-1));
    EXPECT_EQ(view->cuts[0].distance, PlaneDistance::from_int(-168));
}

// The sphere's front is about 212 units ahead: what is there keeps its size, and what is behind it grows as the field
// of view shrinks, until the eye has the wall behind it.
TEST(ShownView, KeepsTheSizeOfWhatIsInTheMiddleWhileItZooms) {
    const Level level = demo_level();
    const Camera camera = camera_before_sphere();
    double far_before = 0;
    for (const std::int32_t degrees : {120, 85, 80, 10}) {
        const auto view = other_view(false, degrees, camera, {}, level);
        ASSERT_TRUE(view);
        EXPECT_NE(place_eye(level, view->eye).leaf, kSolidOutside);
        double least = 1e9;
        for (int y = 100; y < 352; ++y)
            least = std::min(least, std::abs(size_at(*view, y) - size_at(first_person_view(camera), y)));
        EXPECT_LT(least, 0.3) << degrees;
        const double far = size_at(*view, 900);
        EXPECT_GT(far, degrees == 10 ? far_before - 1e-9 : far_before);
        far_before = far;
    }
}

// A unit at depth 1 would be 0.29 pixels there.
TEST(ShownView, ThatCannotBeDrawnIsTheCameras) {
    const ScreenMode narrow{160, 100, {1, 100}};
    Camera camera = camera_before_sphere();
    camera.field_of_view = Degrees::from_int(30);
    EXPECT_TRUE(other_view(false, 80, camera, narrow, demo_level()));
    EXPECT_NE(other_view(false, 80, camera, {}, demo_level())->eye, camera.eye) << "wider than the player's own";
    EXPECT_FALSE(other_view(false, 120, camera, narrow, demo_level()));
    EXPECT_TRUE(other_view(false, 120, camera, {}, demo_level()));
}

std::string press(Action command, ViewOptions& options) {
    return apply(command, options, {1600, 1200});
}

TEST(ShownView, ZoomsBetweenItsLimitsAndIsOffAt90Degrees) {
    ViewOptions options;
    press(Action::Isometric, options);
    EXPECT_EQ(press(Action::ZoomIn, options),
              "{zoom-in} {zoom-out} Zoom against dolly: 80 degrees, as far as there is room behind you");
    EXPECT_FALSE(options.is_isometric) << "it would hide what the message tells of";
    EXPECT_EQ(press(Action::ZoomOut, options), "{zoom-in} {zoom-out} Zoom against dolly: off");
    EXPECT_EQ(options.zoom_degrees, 0);
    for (int i = 0; i < 3; ++i) press(Action::ZoomOut, options);
    EXPECT_EQ(options.zoom_degrees, 120);
    press(Action::ZoomOut, options);
    EXPECT_EQ(options.zoom_degrees, 0) << "the exhibit's button is the only one of a pad";
    for (int i = 0; i < 20; ++i) press(Action::ZoomIn, options);
    EXPECT_EQ(options.zoom_degrees, 10);
}

TEST(PictureIn, AnUprightWindowIsUprightWithTheFieldOfViewFromTopToBottom) {
    for (const int degrees : {1, 60, 90, 120, 179}) {
        PicturePreferences usual;
        usual.field_of_view = Degrees::from_int(degrees);
        const PicturePreferences upright = picture_in({720, 1280}, usual);
        EXPECT_EQ(upright.mode, (ScreenMode{200, 320, {9, 16}}));
        const double half = degrees * std::acos(-1) / 360;
        const double multiplier =
            std::ldexp(static_cast<double>(make_projection(upright.mode, upright.field_of_view).y.multiplier.raw),
                       -Multiplier::kFractionBits);
        // Half of it across is rounded to a binary angle: from top to bottom that is at most 16/9 as much.
        EXPECT_NEAR(std::atan(160 / multiplier), half, std::acos(-1) / 65536 * 16 / 9);
        EXPECT_EQ(picture_in({1280, 720}, usual), usual);
        EXPECT_EQ(picture_in({720, 720}, usual), usual);
        usual.mode.width_px = 321;  // chosen by the player
        EXPECT_EQ(picture_in({720, 1280}, usual), usual);
    }
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

// A level without planes: all of it is in leaf 1.
GameData data_in(std::int32_t contents) {
    GameData data;
    data.level.leaves.resize(2);
    data.level.leaves[LeafIndex(0)].contents = contents::kSolid;
    data.level.leaves[LeafIndex(1)].contents = contents;
    SubModel world;
    world.root = NodeChild(LeafIndex(1));
    data.level.models.push_back(world);
    return data;
}

GameState state_at(std::int64_t tick, std::int32_t x) {
    GameState state;
    state.tick = tick;
    state.player.position.x = World::from_int(x);
    return state;
}

// Of a game at its start.
PaletteEffects effects_of(ShownPalette& palette, Flashes flashes, const Light& light, bool has_six_bits = false) {
    const GameState state = state_at(0, 0);
    return palette.effects_at({{state, state}, {}}, flashes, light, has_six_bits);
}

TEST(ShownPalette, FlashesAndFadesAfterATeleporterOnly) {
    const GameData data = data_in(contents::kEmpty);
    ShownPalette palette(data);
    const auto flash_at = [&](std::int64_t tick, Flashes flashes) {
        const GameState state = state_at(tick, 0);
        return palette.effects_at({{state, state}, {}}, flashes, {}, false).flash.share_256;
    };
    palette.note_tick(state_at(99, 0), state_at(100, 20));
    EXPECT_EQ(flash_at(99, Flashes::Full), 0) << "walking is none";
    palette.note_tick(state_at(100, 20), state_at(101, 2000));
    EXPECT_GT(flash_at(100, Flashes::Full), 100);
    for (std::int64_t tick = 101; tick < 114; ++tick)
        EXPECT_LT(flash_at(tick, Flashes::Full), flash_at(tick - 1, Flashes::Full)) << tick;
    EXPECT_EQ(flash_at(115, Flashes::Full), 0);
    for (const Flashes flashes : {Flashes::Reduced, Flashes::Off}) EXPECT_EQ(flash_at(100, flashes), 0);
}

TEST(ShownPalette, IsPlainInTheOpenAndTintedInALiquid) {
    const GameData of_air = data_in(contents::kEmpty), of_water = data_in(contents::kWater);
    ShownPalette open(of_air), water(of_water);
    EXPECT_TRUE(effects_of(open, Flashes::Full, {}).is_plain());
    EXPECT_FALSE(effects_of(open, Flashes::Full, {100, 150}).is_plain());
    EXPECT_EQ(effects_of(water, Flashes::Off, {}).liquid, (Tint{{130, 80, 50}, 128}));
}

// The tube's colours, then gamma of the display; both of the light that was asked for last.
TEST(ShownPalette, ATubesColoursComeBeforeGamma) {
    const GameData data = data_in(contents::kEmpty);
    ShownPalette palette(data);
    const GammaTable tube = make_tube_table(), gamma = make_gamma_table(150);
    EXPECT_EQ(effects_of(palette, Flashes::Full, {100, 100, true}).gamma, tube);
    const auto both = effects_of(palette, Flashes::Full, {100, 150, true}).gamma;
    ASSERT_TRUE(both);
    for (std::size_t value = 0; value < 256; ++value) ASSERT_EQ((*both)[value], gamma[tube[value]]) << value;
    EXPECT_EQ(effects_of(palette, Flashes::Full, {200, 100}).gamma, std::nullopt);
}

// Asked for alone, and after gamma: never more than 3 of 255 beside it, and 64 values in all.
TEST(ShownPalette, AVgaShowsSixBitsOfWhatGammaMade) {
    const GameData data = data_in(contents::kEmpty);
    ShownPalette palette(data);
    for (const std::int32_t gamma_100 : {100, 150}) {
        const GammaTable gamma = make_gamma_table(gamma_100);
        const auto shown = effects_of(palette, Flashes::Full, {100, gamma_100}, true).gamma;
        ASSERT_TRUE(shown);
        for (std::size_t value = 0; value < 256; ++value)
            EXPECT_LE(std::abs((*shown)[value] - gamma[value]), 3) << value;
        EXPECT_LE(std::set<std::uint8_t>(shown->begin(), shown->end()).size(), 64u);
        EXPECT_EQ((*shown)[255], 255);
    }
}

}  // namespace
}  // namespace oblong::test::shown_view_test
