#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/library/hall.h"
#include "tests/support/refusal.h"

namespace oblong::test {
namespace {

TEST(LibraryModel, MovesWithWhatItHas) {
    Stage stage(grey_palette());
    Model square = square_of(50, 200), other;
    const Picture before = drawn(stage, square, pose_at(100, 0, 0));
    other = std::move(square);
    Stage moved_stage = std::move(stage);
    EXPECT_EQ(drawn(moved_stage, other, pose_at(100, 0, 0)).pixels, before.pixels);
    square = Model();
    EXPECT_EQ(square.frame_count(), 1);
}

// A picture of 20 by 10 units at a distance of 100, from all around: as wide and high as in doubles.
TEST(LibraryModel, SpriteTurnsToTheEye) {
    Stage stage(grey_palette());
    Picture picture = Picture::of_size(40, 20);
    picture.pixels.assign(800, 90);
    fill_rectangle(picture.canvas(), 0, 0, 4, 4, 200);  // its left upper corner
    const Model sprite = Model::sprite(picture, 128);
    EXPECT_EQ(sprite.bounds(), (Bounds{pose_at(0, -10, 0), pose_at(0, 10, 10)}));
    for (const int yaw : {0, 45, 133, 270}) {
        stage.look(moved(pose_at(0, 0, 0, yaw), -100 * 256, 0));
        Picture shown = drawn(stage, sprite, {});
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 320; ++x) {
                const double across = (x + 0.5 - 160) / 160 * 100, up = (100 - y - 0.5) * 1.2 / 160 * 100;
                const double edge = std::min({10 - std::abs(across), up, 10 - up});
                if (std::abs(edge) > 0.5) {
                    ASSERT_EQ(pixel_at(shown.canvas(), x, y) != 0, edge > 0) << yaw << ": " << x << ", " << y;
                }
            }
        EXPECT_EQ(pixel_at(shown.canvas(), 144, 87), 200) << yaw;
    }
}

// A place 100 ahead, 30 to the left and 20 up, in doubles.
TEST(LibraryModel, PlacesAreProjectedToTheirPixels) {
    const ScreenMode mode{640, 400, {4, 3}};
    const Pose eye = pose_at(7, 8, 9, 90), place = moved(eye, 100 * 256, -30 * 256, 20 * 256);
    const double column = 320 - 320 * 0.3 / std::tan(30 * 3.14159265358979 / 180),
                 row = 200 - 320 * 0.2 / 1.2 / std::tan(30 * 3.14159265358979 / 180);
    const auto pixel = project(place, eye, mode, 60);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->column + 0.5, column, 0.6);
    EXPECT_NEAR(pixel->row + 0.5, row, 0.6);
    EXPECT_FALSE(project(moved(eye, -100 * 256, 0), eye, mode));
    EXPECT_FALSE(project(eye, eye, mode));
    EXPECT_GT(project(moved(eye, 256, 90 * 256), eye, mode)->column, 640) << "beside the picture";
}

TEST(LibraryStage, EdgesLieAroundWhatIsDrawn) {
    Stage stage(grey_palette());
    stage.look({});
    const Model square = square_of(50, 200);
    Picture filled = drawn(stage, square, pose_at(100, 0, 0)), edges = drawn(stage, square, pose_at(100, 0, 0), 7);
    for (int y = 1; y < 199; ++y)
        for (int x = 1; x < 319; ++x) {
            int inside = 0;
            for (int i = 0; i < 9; ++i) inside += pixel_at(filled.canvas(), x + i % 3 - 1, y + i / 3 - 1) == 200;
            const bool is_diagonal = std::abs((x - 80) / 160.0 - (y - 33.3) / 133.3) < 0.02;
            if (inside == 0 || (inside == 9 && !is_diagonal)) {
                ASSERT_EQ(pixel_at(edges.canvas(), x, y), 0) << x << ", " << y;
            }
        }
    EXPECT_GE(std::count(edges.pixels.begin(), edges.pixels.end(), 7), 2 * 160 + 2 * 133);
    EXPECT_EQ(drawn(stage, square, pose_at(-100, 0, 0), 7).pixels, Picture::of_size(320, 200).pixels) << "behind";
}

TEST(LibraryStage, DrawsInAnotherMode) {
    Stage stage(grey_palette()), wide(grey_palette(), {640, 400, {4, 3}});
    const Model square = square_of(50, 200);
    stage.set_mode({640, 400, {4, 3}});
    Picture first = Picture::of_size(640, 400), second = first;
    stage.draw(square, pose_at(100, 0, 0), first.canvas());
    wide.draw(square, pose_at(100, 0, 0), second.canvas());
    EXPECT_EQ(first.pixels, second.pixels);
    EXPECT_THROW(stage.draw(square, {}, Picture::of_size(320, 200).canvas()), std::runtime_error);
}

// A square without materials that lies on the ground if z is up, with a picture of two colours.
TEST(LibraryModel, FileInMemoryHasTheAxesAndThePictureThatItIsTold) {
    const std::string text = "v 0 0 0\nv 8 0 0\nv 8 8 0\nv 0 8 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    const File file("square.obj", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    const Palette palette = grey_palette();
    EXPECT_EQ(Model(file, palette).bounds(), (Bounds{pose_at(0, 0, 0), pose_at(0, 8, 8)}));
    Picture halves = Picture::of_size(2, 1);
    halves.pixels = {50, 150};
    const Model flat(file, palette, 512, {.is_z_up = true, .picture = halves});
    EXPECT_EQ(flat.bounds(), (Bounds{pose_at(0, 0, 0), pose_at(16, 16, 0)}));
    Stage stage(palette);
    stage.look(pose_at(8, 8, 10, 90, 90));  // from above, north up
    Picture shown = drawn(stage, flat, {});
    EXPECT_EQ(pixel_at(shown.canvas(), 120, 100), 50);
    EXPECT_EQ(pixel_at(shown.canvas(), 200, 100), 150);
    const std::string said = refusal<std::runtime_error>([&] { Model(File("odd.obj", file.bytes.first(9)), palette); });
    EXPECT_TRUE(said.starts_with("odd.obj: ")) << said;
}

}  // namespace
}  // namespace oblong::test
