#include "game/program/view_options.h"

#include <gtest/gtest.h>

namespace oblong::test::view_options_test {
namespace {

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
}  // namespace oblong::test::view_options_test
