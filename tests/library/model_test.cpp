#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/library/hall.h"

namespace oblong::test {
namespace {

// It would take minutes if each triangle looked at those before it. The box is that of all: the first alone is ahead.
TEST(LibraryModel, OfAHundredThousandTrianglesTheFirstIsSeenLikeTheLast) {
    Stage stage(grey_palette());
    const auto seen = [&](const Model& model) {
        stage.look(pose_at(-60, 0, 0));
        return drawn(stage, model, pose_at(0, 0, 0)).pixels;
    };
    Model alone = square_of(10, 200), many = square_of(10, 200);
    const std::int32_t skin = many.add_picture(Picture::of_size(1, 1));
    for (std::int32_t i = 0; i < 100'000; ++i) many.add_triangle({-200, i, 0}, {-200, i, 1}, {-200, i + 1, 0}, skin);
    EXPECT_NE(seen(alone), seen(Model()));
    EXPECT_EQ(seen(many), seen(alone));
}

TEST(LibraryStage, SquareIsSquareOnTheDisplayAndNearerOnesHideIt) {
    Stage stage(grey_palette());
    const Model far_square = square_of(50, 200), near_square = square_of(10, 100);
    for (const bool far_first : {true, false}) {
        Picture picture = Picture::of_size(320, 200);
        stage.look({});
        if (far_first) stage.draw(far_square, pose_at(200, 0, 0), picture.canvas());
        stage.draw(near_square, pose_at(100, 0, 0), picture.canvas());
        if (!far_first) stage.draw(far_square, pose_at(200, 0, 0), picture.canvas());
        // At 90 degrees 160 columns are as wide as it is far; rows are 1.2 times as high as columns are wide.
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 320; ++x) {
                const double across = std::abs(x + 0.5 - 160) / 160, down = std::abs(y + 0.5 - 100) * 1.2 / 160;
                const double place = std::max(across, down);
                if (std::abs(place - 0.1) < 0.005 || std::abs(place - 0.25) < 0.005) continue;  // an edge
                ASSERT_EQ(pixel_at(picture.canvas(), x, y), place < 0.1    ? 100
                                                            : place < 0.25 ? 200
                                                                           : 0)
                    << x << ", " << y;
            }
    }
}

// Turned left by 30 degrees: its left side comes to 75 units, its right side goes to 125.
TEST(LibraryStage, AModelTurnsByItsYaw) {
    Stage stage(grey_palette());
    Picture picture = drawn(stage, square_of(50, 200), pose_at(100, 0, 0, 30));
    const double left = 160 - 160 * 50 * std::sqrt(0.75) / 75, right = 160 + 160 * 50 * std::sqrt(0.75) / 125;
    for (int x = 0; x < 320; ++x)
        if (std::abs(x + 0.5 - left) > 1 && std::abs(x + 0.5 - right) > 1) {
            ASSERT_EQ(pixel_at(picture.canvas(), x, 100), x > left && x < right ? 200 : 0) << x;
        }
}

// Also the last 32, which glow in levels.
TEST(LibraryStage, LightsEveryColour) {
    Stage stage(grey_palette());
    stage.set_light(128);
    for (const int colour : {100, 223, 224, 240, 254}) {
        stage.look({});
        Picture picture = drawn(stage, square_of(50, static_cast<std::uint8_t>(colour)), pose_at(100, 0, 0));
        EXPECT_NEAR(pixel_at(picture.canvas(), 160, 100), colour / 2.0, 5);
    }
}

// Left half holes, in front of another square.
TEST(LibraryStage, ShowsWhatIsBehindTheHolesOfAModel) {
    Stage stage(grey_palette());
    Model front;
    Picture half = Picture::of_size(2, 1);
    half.pixels = {kTransparent, 90};
    const std::int32_t skin = front.add_picture(half);
    const Corner left_up{0, 50, 50, 0, 0}, right_up{0, -50, 50, 2, 0}, right_down{0, -50, -50, 2, 1},
        left_down{0, 50, -50, 0, 1};
    front.add_triangle(left_up, right_up, right_down, skin);
    front.add_triangle(left_up, right_down, left_down, skin);
    Picture picture = drawn(stage, front, pose_at(100, 0, 0));
    EXPECT_EQ(pixel_at(picture.canvas(), 130, 100), 0);
    stage.draw(square_of(50, 200), pose_at(150, 0, 0), picture.canvas());
    EXPECT_EQ(pixel_at(picture.canvas(), 130, 100), 200) << "a hole has no depth";
    EXPECT_EQ(pixel_at(picture.canvas(), 190, 100), 90);
}

TEST(LibraryStage, NothingOfTheLastPictureHidesTheNext) {
    Stage stage(grey_palette());
    drawn(stage, square_of(50, 200), pose_at(100, 0, 0));
    stage.look({});
    Picture picture = drawn(stage, square_of(50, 200), pose_at(200, 0, 0));
    EXPECT_EQ(pixel_at(picture.canvas(), 160, 100), 200);
}

TEST(LibraryStage, SideLightFollowsLambert) {
    Stage stage(grey_palette());
    const auto grey_at = [&](std::int32_t x, std::int32_t z) {
        stage.look({});
        stage.set_light(0, 256, x, 0, z);
        Picture picture = drawn(stage, square_of(50, 200), pose_at(100, 0, 0));
        return static_cast<double>(pixel_at(picture.canvas(), 160, 100));
    };
    EXPECT_EQ(grey_at(-1, 0), 200);
    EXPECT_NEAR(grey_at(-1, 1), 200 * std::sqrt(0.5), 8);  // 64 shades
    EXPECT_NEAR(grey_at(1, 0), 0, 8);
}

// One that were copied would be destroyed twice.
template <class... Each>
constexpr bool are_only_moved = (std::is_nothrow_move_constructible_v<Each> && ...) &&
                                (std::is_nothrow_move_assignable_v<Each> && ...) &&
                                !(std::is_copy_assignable_v<Each> || ...) &&
                                !(std::is_copy_constructible_v<Each> || ...);
static_assert(are_only_moved<Window, Speaker, Model, Stage, LevelScene>);

TEST(LibraryModel, WarningsOfItsFileAndOfALevelsAreTold) {
    const TemporaryFolder folder;
    const std::string file =
        folder.write("odd.obj", std::string("mtllib none.mtl\nv 0 0 0\nv 9 0 0\nv 0 9 0\nusemtl red\nf 1 2 3\n"));
    const Model odd(file, red_palette());
    ASSERT_FALSE(odd.warnings().empty());
    EXPECT_NE(odd.warnings().front().find("none.mtl"), std::string::npos) << odd.warnings().front();
    EXPECT_TRUE(Model().warnings().empty());
    EXPECT_TRUE(Hall().level.warnings().empty());
    const Hall hall("", entity("func_wall", {{"origin", "8 0 0"}}, box({0, 0, 0}, {8, 8, 8})) +
                            entity_at("misc_model", {64, 0, 24}, {{"model", "none.obj"}}) +
                            entity_at("misc_rain", {0, 0, 100}, {{"count", "many"}}));
    std::string said;
    for (const std::string& warning : hall.level.warnings()) said += warning + "\n";
    for (const char* part : {"(func_wall): origin is", "none.obj", "(misc_rain): count"})
        EXPECT_NE(said.find(part), std::string::npos) << part << ": " << said;
}

TEST(LibraryModel, WrongNumbersAreRefused) {
    Model model;
    for (const Picture& picture : {Picture{2, 2, {1, 2, 3}}, Picture{2, 1, {1, 2, 3}}, Picture{-1, -1, {1}}, Picture{}})
        EXPECT_THROW(model.add_picture(picture), std::runtime_error);
    EXPECT_EQ(model.frame_count(), 1);
    EXPECT_THROW(Model("/nowhere/a.obj", grey_palette()), std::runtime_error);
    EXPECT_THROW(Model("/nowhere/a.obj", grey_palette(), 0), std::runtime_error);
}

}  // namespace
}  // namespace oblong::test
