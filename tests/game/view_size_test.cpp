#include "game/view/view_size.h"

#include <gtest/gtest.h>

#include "game/program/view_choice.h"
#include "game/view/game_renderer.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

const GameData& museum() {
    static const GameData data = load_game({"", "", test::build_folder() + "/assets", ""});
    return data;
}

/// A small view is what a renderer of that mode alone draws, each pixel or each column twice.
TEST(ViewSize, ShowsThePictureOfASmallerModeInTheMiddle) {
    const GameLevel level = make_game_level(museum().level);
    const GameState state = start_of(level);
    const InterpolatedState at{state, state};
    const GameView view{at, camera_at(at, {}, Degrees::from_int(90)), false, {}};
    for (const bool doubles : {false, true}) {
        GameRenderer renderer(museum(), level, ScreenMode{}, nullptr, {60, doubles});
        GameRenderer alone(museum(), level, {doubles ? 96 : 192, 120, {4, 3}});
        renderer.draw(view, {});
        alone.draw(view, {});
        const Framebuffer picture = renderer.canvas(), expected = alone.canvas();
        std::int64_t wrong = 0;
        for (std::int32_t y = 0; y < 120; ++y)
            for (std::int32_t x = 0; x < 192; ++x)
                wrong += picture.row(40 + y)[64 + x] != expected.row(y)[doubles ? x / 2 : x];
        EXPECT_EQ(wrong, 0) << doubles;
        for (const auto& [x, y] : {std::pair{0, 0}, {319, 199}, {62, 100}, {257, 100}, {160, 38}, {160, 161}})
            EXPECT_EQ(picture.row(y)[x], picture.row(0)[0]) << x << " " << y;
    }
}

TEST(ViewSize, LeavesPixelsTheirShape) {
    for (const ScreenMode& picture : {ScreenMode{}, ScreenMode{200, 320, {9, 16}}, ScreenMode{361, 203, {16, 9}}})
        for (int size = 30; size <= 100; size += 10) {
            const ScreenMode single = place_view(picture, {size, false}).mode;
            EXPECT_EQ(single.pixel().reduced(), picture.pixel().reduced()) << size;
            const ScreenMode twice = place_view(picture, {size, true}).mode;
            EXPECT_EQ(twice.pixel().reduced(), (picture.pixel() * Ratio{2, 1}).reduced()) << size;
        }
}

/// 179 degrees need 115x86 pixels (is_drawable()).
TEST(ViewSize, IsWholeWhereASmallOneCannotBeDrawn) {
    PicturePreferences picture;
    picture.size_100 = 30;
    EXPECT_EQ(drawable_size(picture), (ViewSize{30, false}));
    picture.field_of_view = Degrees::from_int(179);
    EXPECT_EQ(drawable_size(picture), ViewSize{});
}

/// The time of a picture on a machine: so much for any picture, and for 1,000 pixels.
Preferences chosen_on(std::int64_t fixed_us, std::int64_t us_per_1000) {
    Preferences preferences;
    ViewChoice choice;
    choice.begin(preferences);
    for (int picture = 0; picture < 100 && choice.is_on(); ++picture) {
        const ScreenMode mode = place_view(preferences.mode, preferences).mode;
        const std::int64_t us = fixed_us + us_per_1000 * mode.width_px * mode.height_px / 1000;
        choice.note(static_cast<std::uint64_t>(picture == 0 ? 10 * us : us), preferences);
    }
    EXPECT_FALSE(choice.is_on());
    return preferences;
}

TEST(ViewChoice, TakesTheLargestViewThatIsFastEnough) {
    EXPECT_EQ(chosen_on(10'000, 1000).size_100, 100);
    EXPECT_FALSE(chosen_on(10'000, 1000).doubles_columns) << "74 ms";
    EXPECT_TRUE(chosen_on(50'000, 1000).doubles_columns) << "114 ms, and 82 of half the columns";
    const Preferences slow = chosen_on(70'000, 1000), slowest = chosen_on(500'000, 1000);
    EXPECT_LT(slow.size_100, 100);
    EXPECT_LT(slowest.size_100, slow.size_100);
    EXPECT_EQ(slowest.preset, Preset::Year1991);
}

TEST(ViewChoice, EndsWhenThePlayerChooses) {
    Preferences preferences;
    ViewChoice choice;
    choice.begin(preferences);
    preferences.size_100 = 90;
    for (int picture = 0; picture < 20; ++picture) choice.note(1'000'000, preferences);
    EXPECT_FALSE(choice.is_on());
    EXPECT_EQ(static_cast<ViewSize>(preferences), (ViewSize{90, false}));
}

}  // namespace
}  // namespace oblong
