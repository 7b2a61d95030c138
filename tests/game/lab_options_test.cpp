#include "game/lab/lab_options.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "game/lab/lab.h"
#include "game/program/view_options.h"
#include "tests/support/palettes.h"

namespace oblong::test::lab_options_test {
namespace {

constexpr ScreenMode kMode{};
constexpr WindowSize kWindow{1600, 1200};

std::string press(Action command, ViewOptions& options) {
    return apply(command, options, kWindow);
}

const Dial& chosen(const ViewOptions& options) {
    return all_dials()[options.lab.dial];
}

TEST(LabOptions, ArrowsTurnDialsWhileTheLabIsOpenOnly) {
    ViewOptions options;
    press(Action::DialCoarser, options);
    EXPECT_EQ(options.preferences.accuracy, Accuracy{});
    press(Action::LabPanel, options);
    EXPECT_EQ(chosen(options).name, "perspective");
    press(Action::DialCoarser, options);
    EXPECT_EQ(options.preferences.accuracy.texturing, Texturing::Every8);
    press(Action::DialFiner, options);
    press(Action::DialFiner, options);
    EXPECT_EQ(options.preferences.accuracy.texturing, Texturing::BoundedTexels);
    for (int i = 0; i < 20; ++i) press(Action::DialCoarser, options);
    EXPECT_EQ(options.preferences.accuracy.texturing, Texturing::Affine);
    EXPECT_EQ(options.lab.before.texturing, Texturing::Every32);  // a turn at the end changes nothing
}

TEST(LabOptions, EachDialIsReachedAndExplained) {
    ViewOptions options;
    press(Action::LabPanel, options);
    const std::size_t first = options.lab.dial;
    for (std::size_t i = 0; i < all_dials().size(); ++i) {
        const std::string said = press(Action::DialDown, options);
        EXPECT_EQ(said.rfind(std::string(chosen(options).caption) + ": ", 0), 0u) << said;
        EXPECT_EQ(said.find("Its error is real") == std::string::npos, chosen(options).changes_work) << said;
    }
    EXPECT_EQ(options.lab.dial, first);
    for (std::size_t i = 0; i <= first; ++i) press(Action::DialUp, options);
    EXPECT_EQ(options.lab.dial, all_dials().size() - 1);
}

TEST(LabOptions, RemembersTheSettingBefore) {
    ViewOptions options;
    EXPECT_EQ(options.lab.before, accuracy_of(Preset::Exact));
    options.preferences.preset = Preset::Year1991;
    press(Action::AccuracyTier, options);
    EXPECT_EQ(options.lab.before, Accuracy{});
    press(Action::AccuracyTier, options);
    EXPECT_EQ(options.lab.before, accuracy_of(Preset::Year1994));
    EXPECT_EQ(options.preferences.accuracy, accuracy_of(Preset::Year1996));
}

TEST(LabOptions, FlipsEachHalfSecond) {
    ViewOptions options;
    press(Action::FlipSettings, options);
    const auto shown = [&](std::uint64_t now_us) {
        return shown_setting(options.lab, options.preferences.accuracy, now_us);
    };
    EXPECT_EQ(shown(499'999), options.preferences.accuracy);
    EXPECT_EQ(shown(500'000), options.lab.before);
    EXPECT_EQ(shown(1'000'000), options.preferences.accuracy);
    press(Action::FlipSettings, options);
    EXPECT_EQ(shown(500'000), options.preferences.accuracy);
}

TEST(LabOptions, SettingsHaveShortNames) {
    for (const Preset preset : kPresets) EXPECT_EQ(setting_name(accuracy_of(preset)), name_of(preset));
    Accuracy accuracy = accuracy_of(Preset::Year1996);
    accuracy.shades = 32;
    EXPECT_EQ(setting_name(accuracy), "1996, shades 32");
    accuracy.dithers_light = true;
    EXPECT_EQ(setting_name(accuracy), "1996, 2 dials changed");
}

TEST(LabOptions, DialsThatMeanNothingAreIdle) {
    Accuracy accuracy;
    const auto idle = [&] {
        std::string names;
        for (const Dial& dial : all_dials())
            if (is_idle(dial, accuracy)) names += std::string(dial.name) + " ";
        return names;
    };
    EXPECT_EQ(idle(), "texel-bound ");
    accuracy.texturing = Texturing::BoundedTexels;
    accuracy.mip = MipSelection::None;
    EXPECT_EQ(idle(), "mip-bias pixel-bound ");
}

// The picture is 1600 of the window's pixels wide: 400 of the mouse's counts are a quarter of it.
TEST(Split, MovesWithTheMouseWhileAButtonIsHeld) {
    LabOptions options;
    const PresentRect shown = layout(kWindow, kMode, ShownAs::OnDisplay, Scaling::SharpBilinear);
    Controls controls;
    controls.mouse_x = 400;
    controls.mouse_y = 7;
    controls.holds_button = true;
    drag_split(shown, options, controls);
    EXPECT_EQ(options.split_16, 32'768);  // not on
    EXPECT_EQ(controls.mouse_x, 400);
    options.splits = true;
    drag_split(shown, options, controls);
    EXPECT_EQ(options.split_16, 49'152);
    EXPECT_EQ(controls.mouse_x, 0);  // the view stays
    EXPECT_EQ(controls.mouse_y, 0);
    controls = {};
    controls.mouse_x = -100;
    drag_split(shown, options, controls);
    EXPECT_EQ(options.split_16, 49'152);  // no button
    controls.holds_button = true;
    controls.mouse_x = -2'000'000'000;
    drag_split({}, options, controls);
    EXPECT_EQ(options.split_16, 0);
}

TEST(Split, ShowsTheOtherPictureRightOfTheLine) {
    const TextColours colours = text_colours_of(grey_palette());
    std::vector<std::uint8_t> ours(40, 1), other(40, 2);
    LabOptions options;
    options.split_16 = 65'536 * 3 / 10;
    draw_split(options, {other.data(), 10, 4, 10}, colours, {ours.data(), 10, 4, 10});
    const std::uint8_t b = colours.bright, d = colours.dark;
    for (int y = 0; y < 4; ++y)
        EXPECT_EQ(std::vector<std::uint8_t>(ours.begin() + 10 * y, ours.begin() + 10 * y + 10),
                  (std::vector<std::uint8_t>{1, d, b, 2, 2, 2, 2, 2, 2, 2}));
}

TEST(ErrorMap, HasABandForEachDoubling) {
    EXPECT_EQ(ErrorMap::band_of(-1), 0u);
    EXPECT_EQ(ErrorMap::band_of(0.124F), 0u);
    EXPECT_EQ(ErrorMap::band_of(0.125F), 1u);
    EXPECT_EQ(ErrorMap::band_of(0.999F), 3u);
    EXPECT_EQ(ErrorMap::band_of(1), 4u);
    EXPECT_EQ(ErrorMap::band_of(4), ErrorMap::kBands - 1);
    EXPECT_EQ(ErrorMap::band_of(std::numeric_limits<float>::infinity()), ErrorMap::kBands - 1);
}

// A palette of the map's own hues, so that each band has another colour; dark and bright pixels stay apart.
TEST(ErrorMap, ColoursByBandAndBrightness) {
    Palette palette;
    for (int i = 0; i < 256; ++i) {
        const auto channel = [](int bits) { return static_cast<std::uint8_t>(bits * 255 / 7); };
        palette.colours[static_cast<std::size_t>(i)] = {channel(i >> 5), channel(i >> 2 & 7), channel((i & 3) * 7 / 3)};
    }
    const std::uint8_t dark = 0, bright = 255;
    std::vector<std::uint8_t> pixels;
    std::vector<TexelError> errors;
    for (const float pixels_off : {0.F, 0.2F, 0.3F, 0.6F, 1.5F, 3.F, 9.F})
        for (const std::uint8_t colour : {dark, bright}) {
            pixels.push_back(colour);
            errors.push_back({pixels_off, 0});
        }
    ErrorMap(palette, ColourScheme::Standard).draw(errors, {pixels.data(), 14, 1, 14});
    for (std::size_t band = 0; band < ErrorMap::kBands; ++band) {
        EXPECT_LE(luminance_1000(palette.colours[pixels[2 * band]]),
                  luminance_1000(palette.colours[pixels[2 * band + 1]]));
        for (std::size_t other = 0; other < band; ++other) EXPECT_NE(pixels[2 * band + 1], pixels[2 * other + 1]);
    }
}

TEST(ViewDials, FollowEachOptionThatALevelCanAskFor) {
    EXPECT_EQ(view_dials_of({}), kUsualView);
    for (const Preset preset : kPresets)
        EXPECT_EQ(value_named(all_view_dials()[0], name_of(preset)), static_cast<std::uint8_t>(preset));
    const std::vector<std::pair<Action, ViewDials>> presses{{Action::AccuracyTier, {5, 1, 0, 0, 0, 0}},
                                                            {Action::AccuracyTier, {0, 1, 0, 0, 0, 0}},
                                                            {Action::ProjectionAspect, {0, 0, 0, 0, 0, 0}},
                                                            {Action::DisplayAspect, {0, 0, 1, 0, 0, 0}},
                                                            {Action::Isometric, {0, 0, 1, 1, 0, 0}},
                                                            {Action::Wireframe, {0, 0, 1, 1, 1, 0}},
                                                            {Action::ZoomIn, {0, 0, 1, 0, 1, 8}}};
    ViewOptions options, followed;
    for (const auto& [command, wanted] : presses) {
        const ViewDials before = view_dials_of(options);
        press(command, options);
        EXPECT_EQ(view_dials_of(options), wanted);
        follow_view(before, wanted, followed);
        EXPECT_EQ(view_dials_of(followed), wanted);
    }
    followed.zoom_degrees = 0;  // the player turns it off during a replay, whose own zoom stays
    follow_view(presses.back().second, presses.back().second, followed);
    EXPECT_EQ(followed.zoom_degrees, 0);
    options.preferences.accuracy.shades = 16;
    EXPECT_EQ(view_dials_of(options)[0], 6) << "no preset";
}

}  // namespace
}  // namespace oblong::test::lab_options_test
