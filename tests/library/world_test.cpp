#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/library/oblong.h"
#include "tests/map/map_source.h"
#include "tests/support/folders.h"
#include "tests/support/palettes.h"
#include "tests/support/refusal.h"

namespace oblong::test {
namespace {

// The space of -256..256 each way, 256 high, with things in it.
std::string hall(const std::string& brushes, const std::string& entities) {
    return level(
        room({-256, -256, 0}, {256, 256, 256}) + brushes,
        entity_at("info_player_start", {-100, 0, 24}, {{"angle", "90"}}) + entity_at("light", {0, 0, 200}) + entities);
}

// In units: east, north, up.
Pose beside(Pose pose, std::int32_t east, std::int32_t north, std::int32_t up) {
    pose.x_256 += east * 256;
    pose.y_256 += north * 256;
    pose.z_256 += up * 256;
    return pose;
}

// Greys, 64 reds, and of red the texture "other".
Palette red_palette() {
    Palette palette = grey_palette();
    palette.colours[1] = {160, 160, 160};
    palette.colours[3] = {255, 0, 0};
    for (std::uint8_t i = 192; i != 0; ++i) palette.colours[i] = {static_cast<std::uint8_t>((i - 191) * 3), 0, 0};
    return palette;
}

struct Hall {
    explicit Hall(const std::string& brushes = "", const std::string& entities = "")
        : file(folder.write("hall.bsp", bytes_of(hall(brushes, entities)))), level(file, red_palette()) {}

    // Goes on for some steps of 8 units, and falls between them.
    Pose walk_east(Pose eye, int steps) const {
        for (int i = 0; i < steps; ++i) {
            eye = level.walked(eye, beside(eye, 8, 0, 0));
            if (!level.stands(eye)) eye = level.walked(eye, beside(eye, 0, 0, -20));
        }
        return eye;
    }

    TemporaryFolder folder;
    std::string file;
    LevelScene level;
};

double units(std::int32_t units_256) {
    return units_256 / 256.0;
}

// A body is 32 units wide; its eye is 22 above its middle, 24 above its feet.
constexpr double kStop = 256 - 16, kEye = 24 + 22;

TEST(LibraryLevel, BodyStopsAtAWallAndSlidesAlongIt) {
    const Hall hall;
    const Pose start = hall.level.start();
    EXPECT_EQ(start.yaw_256, 90 * 256);
    EXPECT_NEAR(units(start.x_256), -100, 1e-9);
    EXPECT_NEAR(units(start.z_256), kEye, 1.01);
    const Pose at_wall = hall.walk_east(start, 60);
    EXPECT_NEAR(units(at_wall.x_256), kStop, 0.1);
    EXPECT_NEAR(units(at_wall.z_256), kEye, 0.1);
    EXPECT_TRUE(hall.level.stands(at_wall));
    const Pose along = hall.level.walked(at_wall, beside(at_wall, 50, 30, 0));
    EXPECT_NEAR(units(along.y_256), 30, 0.1);
    EXPECT_NEAR(units(along.x_256), kStop, 0.1);
    EXPECT_FALSE(hall.level.stands(hall.level.walked(start, beside(start, 0, 0, 50))));
}

TEST(LibraryLevel, WayLongerThanTheWorldEndsAtTheNextWall) {
    const Hall hall;
    constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
    const Pose start = hall.level.start();
    EXPECT_NEAR(units(hall.level.walked(start, moved(start, 0, kMost)).x_256), kStop, 0.1);
    EXPECT_NEAR(units(hall.level.walked(start, moved(start, 0, -kMost)).x_256), -kStop, 0.1);
    const Pose outside = moved(start, 0, kMost);
    EXPECT_EQ(moved(outside, kMost, kMost, kMost).x_256, 8'000'000 * 256);
    EXPECT_LE(hall.level.walked(outside, moved(outside, 0, -kMost)).x_256, outside.x_256);
}

TEST(LibraryLevel, BodyClimbsStepsOf18UnitsAndNoHigherOnes) {
    const Hall low(box({50, -256, 0}, {256, 256, 18})), high(box({50, -256, 0}, {256, 256, 20}));
    EXPECT_NEAR(units(low.walk_east(low.level.start(), 25).z_256), kEye + 18, 0.1);
    const Pose before_high = high.walk_east(high.level.start(), 25);
    EXPECT_NEAR(units(before_high.x_256), 50 - 16, 0.1);
    EXPECT_NEAR(units(before_high.z_256), kEye, 0.1);
}

// The pixels of what is red.
std::vector<bool> red_in(Hall& hall, std::int64_t time_ms) {
    Picture picture = Picture::of_size(320, 200);
    hall.level.draw(pose_at(-200, 0, 100), time_ms, picture.canvas());
    std::vector<bool> is_red;
    for (const std::uint8_t pixel : picture.pixels) is_red.push_back(pixel == 3 || pixel >= 192);
    return is_red;
}

TEST(LibraryLevel, DoorIsInTheWayAndSeenUntilItIsMoved) {
    Hall hall("", entity("func_door", {{"targetname", "gate"}}, box({50, -250, 1}, {60, 250, 250}, "other")));
    const auto red_pixels = [&] {
        const std::vector<bool> is_red = red_in(hall, 0);
        return std::count(is_red.begin(), is_red.end(), true);
    };
    const std::int32_t door = hall.level.find_entity("targetname", "gate");
    ASSERT_GE(door, 0);
    EXPECT_EQ(hall.level.entity_value(door, "classname"), "func_door");
    EXPECT_NEAR(units(hall.walk_east(hall.level.start(), 40).x_256), 50 - 16, 1.1);
    EXPECT_GT(red_pixels(), 1000);
    for (const std::int32_t up_256 : {400 * 256, std::numeric_limits<std::int32_t>::max()}) {
        hall.level.move_entity(door, 0, 0, up_256);
        EXPECT_NEAR(units(hall.walk_east(hall.level.start(), 60).x_256), kStop, 0.1);
    }
    EXPECT_EQ(red_pixels(), 0);
    EXPECT_THROW(hall.level.draw({}, 0, Picture::of_size(64, 64).canvas()), std::runtime_error);
    EXPECT_THROW(LevelScene(hall.file, grey_palette(), {320, 200, {4, 0}}), std::runtime_error);
    Picture picture = Picture::of_size(320, 200);
    for (const std::int32_t pitch : {-320, 0, 319})
        EXPECT_THROW(hall.level.draw({}, 0, {picture.pixels.data(), 320, 200, pitch}), std::runtime_error) << pitch;
    EXPECT_EQ(hall.level.find_entity("targetname", "nothing"), -1);
    EXPECT_THROW(hall.level.move_entity(0, 0, 0, 0), std::runtime_error);
    EXPECT_THROW(hall.level.entity_value(1000, "classname"), std::runtime_error);
}

TEST(LibraryLevel, OpenGatesAndWhatIsOnlySeenStopNobody) {
    const std::string brush = box({50, -250, 1}, {60, 250, 250});
    for (const char* passed : {"func_episodegate", "func_bossgate", "func_illusionary"}) {
        const Hall hall("", entity(passed, {}, brush));
        EXPECT_NEAR(units(hall.walk_east(hall.level.start(), 60).x_256), kStop, 0.1) << passed;
    }
    const Hall wall("", entity("func_wall", {}, brush));
    EXPECT_NEAR(units(wall.walk_east(wall.level.start(), 60).x_256), 50 - 16, 1.1);
}

TEST(LibraryLevel, StartMayLieBetweenWholeUnits) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "start.bsp",
        bytes_of(level(room({-256, -256, 0}, {256, 256, 256}),
                       entity("info_player_start", {{"origin", "-100.5 20.25 32.125"}, {"angles", "0 22.5 0"}}) +
                           entity_at("light", {0, 0, 200}))));
    const Pose start = LevelScene(file, grey_palette()).start();
    EXPECT_EQ(units(start.x_256), -100.5);
    EXPECT_EQ(units(start.y_256), 20.25);
    EXPECT_EQ(units(start.z_256), 32.125 + 1 + 22);
    EXPECT_EQ(units(start.yaw_256), 22.5);
}

// What is red in one hall then is so in the other, but for a few pixels on its outline.
void expect_same_red(Hall& turned, Hall& built, std::int64_t time_ms, const std::string& what) {
    const std::vector<bool> shown = red_in(turned, time_ms), expected = red_in(built, time_ms);
    int wrong = 0, right = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        wrong += shown[i] != expected[i];
        right += shown[i] && expected[i];
    }
    EXPECT_GT(right, 500) << what;
    EXPECT_LE(wrong, 10) << what << " at " << time_ms;
}

struct Turned {
    const char* flags;
    std::string as_built;
};

Hall hall_with_wall(const std::string& brush) {
    return Hall("", entity("func_wall", {{"_minlight", "100"}}, brush));
}

// A beam that turns is seen where one is that was built so.
TEST(LibraryLevel, BrushesThatTurnAreSeenWhereTheyAreThen) {
    const std::string beam = box({-60, -10, 80}, {60, 20, 120}, "other");  // about (0, 5, 100)
    for (const auto& [flags, as_built] : {Turned{"0", box({-15, -55, 80}, {15, 65, 120}, "other")},
                                          Turned{"4", box({-60, -15, 85}, {60, 25, 115}, "other")},
                                          Turned{"8", box({-20, -10, 40}, {20, 20, 160}, "other")}}) {
        Hall turning("", entity("func_rotating", {{"speed", "90"}, {"spawnflags", flags}}, beam));
        Hall before = hall_with_wall(beam), after = hall_with_wall(as_built);
        for (const auto& [time_ms, same] : {std::pair{0, &before}, {1000, &after}, {2000, &before}, {9000, &after}})
            expect_same_red(turning, *same, time_ms, flags);
        EXPECT_NEAR(units(turning.walk_east(pose_at(-200, 0, 46), 60).x_256), kStop, 0.1) << "stops nobody";
    }
}

// About its hinge, and by more than a whole turn.
TEST(LibraryLevel, TurnedDoorIsSeenWhereOneIsThatWasBuiltSo) {
    const std::string shut = box({-4, -40, 60}, {4, 40, 140}, "other");  // its hinge: (-4, 40, 120)
    for (const auto& [flags, as_built] : {Turned{"0", box({-4, 40, 60}, {76, 48, 140}, "other")},
                                          Turned{"64", box({-4, 20, 40}, {4, 100, 120}, "other")},
                                          Turned{"128", box({-64, -40, 112}, {16, 40, 120}, "other")}}) {
        Hall hall("", entity("func_door_rotating",
                             {{"origin", "-4 40 120"}, {"spawnflags", flags}, {"_minlight", "100"}}, shut));
        Hall before = hall_with_wall(shut), after = hall_with_wall(as_built);
        const std::int32_t door = hall.level.find_entity("classname", "func_door_rotating");
        for (const auto& [degrees, same] : {std::pair{0, &before}, {90, &after}, {360 + 90, &after}}) {
            hall.level.turn_entity(door, degrees * 256);
            expect_same_red(hall, *same, 0, flags);
        }
    }
}

TEST(LibraryLevel, TurningDoorIsInTheWayWhileItIsShut) {
    const std::string brush = box({50, -250, 1}, {60, 250, 250});
    Hall hall("", entity("func_door_rotating", {{"origin", "50 -250 0"}}, brush) + entity("func_door", {}, brush));
    const std::int32_t hinged = hall.level.find_entity("classname", "func_door_rotating"),
                       sliding = hall.level.find_entity("classname", "func_door");
    hall.level.move_entity(sliding, 0, 0, 400 * 256);
    const auto walked_to = [&] { return units(hall.walk_east(hall.level.start(), 60).x_256); };
    EXPECT_NEAR(walked_to(), 50 - 16, 1.1);
    hall.level.turn_entity(hinged, 5 * 256);
    EXPECT_NEAR(walked_to(), kStop, 0.1);
    hall.level.turn_entity(hinged, 360 * 256);
    EXPECT_NEAR(walked_to(), 50 - 16, 1.1);
    EXPECT_THROW(hall.level.turn_entity(sliding, 0), std::runtime_error);
    EXPECT_THROW(hall.level.move_entity(hinged, 0, 0, 0), std::runtime_error);
    EXPECT_THROW(hall.level.turn_entity(0, 0), std::runtime_error);
    EXPECT_THROW(hall.level.turn_entity(1000, 0), std::runtime_error);
}

// In what() alone, as a program of its own prints it.
TEST(Library, ErrorsOfArgumentsNameThem) {
    const auto said = [](auto work) { return refusal<std::runtime_error>(work); };
    Picture empty;
    Palette palette;
    EXPECT_EQ(said([] { Picture::of_size(0, 5); }), "picture: 0x5 pixels, expected 1 to 4096 a side");
    EXPECT_EQ(said([&] { set_ramp(palette, 9, 3, {}, {}); }), "palette: colours 9 to 3, expected a part of 0 to 255");
    EXPECT_EQ(said([] { Window("", {0, 1}); }), "mode: 0x1 pixels, expected 1 to 4096 a side");
    EXPECT_EQ(said([] { Speaker().add({}, 9); }), "sound: 0 samples at 9 Hz, expected one or more of each");
    EXPECT_EQ(said([] { Speaker().play(0); }), "sound: number 0, expected one that load() or add() returned");
    EXPECT_EQ(said([] { Model().add_triangle({}, {}, {}, 0); }),
              "model: picture 0, expected a number that add_picture() returned");
    EXPECT_EQ(said([&] { Stage(grey_palette()).draw(Model(), {}, empty.canvas()); }),
              "canvas: has 0x0 pixels, expected 320x200, those of the mode");
    EXPECT_EQ(said([&] { save_picture("a.png", empty.canvas(), palette); }),
              "a.png: image: 0 pixels of 0x0, expected all, and one or more a side");
    EXPECT_EQ(said([] { Hall().level.set_accuracy("2026"); }),
              "accuracy: '2026', expected 1991, 1994, 1996, pixel, bounded or exact");
    EXPECT_EQ(said([&] { save_picture("a.bmp", empty.canvas(), palette); }),
              "a.bmp: name: expected one that ends in .png");
}

TEST(LibraryLevel, ErrorsNameTheFile) {
    const TemporaryFolder folder;
    const std::string file = folder.write("broken.bsp", std::string("nothing"));
    const std::string said = refusal<std::runtime_error>([&] { LevelScene(file, grey_palette()); });
    EXPECT_TRUE(said.starts_with(file + ": ")) << said;
}

// Two triangles in one colour, 2 x 2 units around (at, 0, 0), that face west.
void add_square(Model& model, std::int32_t at, std::int32_t half, std::uint8_t colour) {
    Picture picture = Picture::of_size(1, 1);
    picture.pixels = {colour};
    const std::int32_t skin = model.add_picture(picture);
    const Corner left_up{at, half, half}, right_up{at, -half, half}, right_down{at, -half, -half},
        left_down{at, half, -half};
    model.add_triangle(left_up, right_up, right_down, skin);
    model.add_triangle(left_up, right_down, left_down, skin);
}

// It would take minutes if each triangle looked at those before it. The box is that of all: the first alone is ahead.
TEST(LibraryModel, OfAHundredThousandTrianglesTheFirstIsSeenLikeTheLast) {
    const Palette palette = grey_palette();
    Stage stage(palette);
    stage.look(pose_at(-60, 0, 0));
    const auto drawn = [&](const Model& model) {
        Picture picture = Picture::of_size(320, 200);
        stage.look(pose_at(-60, 0, 0));
        stage.draw(model, pose_at(0, 0, 0), picture.canvas());
        return checksum(picture.canvas());
    };
    Model alone, many;
    add_square(alone, 0, 10, 200);
    add_square(many, 0, 10, 200);
    const std::int32_t skin = many.add_picture(Picture::of_size(1, 1));
    for (std::int32_t i = 0; i < 100'000; ++i) many.add_triangle({-200, i, 0}, {-200, i, 1}, {-200, i + 1, 0}, skin);
    EXPECT_NE(drawn(alone), drawn(Model()));
    EXPECT_EQ(drawn(many), drawn(alone));
}

TEST(LibraryLevel, ModelIsShownOnceAlsoIfItIsGoneByThen) {
    Hall hall;
    const Pose eye = pose_at(-100, 0, 46), place = pose_at(100, 0, 46);
    const auto drawn = [&] {
        Picture picture = Picture::of_size(320, 200);
        hall.level.draw(eye, 0, picture.canvas());
        return checksum(picture.canvas());
    };
    const std::uint32_t empty = drawn();
    Model square;
    add_square(square, 0, 30, 3);
    hall.level.show(square, place);
    const std::uint32_t expected = drawn();
    {
        Model gone;
        add_square(gone, 0, 30, 3);
        hall.level.show(gone, place);
    }
    Model other;  // where the other one was
    add_square(other, 0, 10, 200);
    EXPECT_NE(expected, empty);
    EXPECT_EQ(drawn(), expected);
    EXPECT_EQ(drawn(), empty);
}

TEST(LibraryStage, SquareIsSquareOnTheDisplayAndNearerOnesHideIt) {
    Stage stage(grey_palette());
    Model far_square, near_square;
    add_square(far_square, 0, 50, 200);
    add_square(near_square, 0, 10, 100);
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
    Model square;
    add_square(square, 0, 50, 200);
    Picture picture = Picture::of_size(320, 200);
    stage.look({});
    Pose turned = pose_at(100, 0, 0);
    turned.yaw_256 = 30 * 256;
    stage.draw(square, turned, picture.canvas());
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
        Model square;
        add_square(square, 0, 50, static_cast<std::uint8_t>(colour));
        Picture picture = Picture::of_size(320, 200);
        stage.look({});
        stage.draw(square, pose_at(100, 0, 0), picture.canvas());
        EXPECT_NEAR(pixel_at(picture.canvas(), 160, 100), colour / 2.0, 5);
    }
}

// Left half holes, in front of another square.
TEST(LibraryStage, ShowsWhatIsBehindTheHolesOfAModel) {
    Stage stage(grey_palette());
    Model behind, front;
    add_square(behind, 0, 50, 200);
    Picture half = Picture::of_size(2, 1);
    half.pixels = {kTransparent, 90};
    const std::int32_t skin = front.add_picture(half);
    const Corner left_up{0, 50, 50, 0, 0}, right_up{0, -50, 50, 2, 0}, right_down{0, -50, -50, 2, 1},
        left_down{0, 50, -50, 0, 1};
    front.add_triangle(left_up, right_up, right_down, skin);
    front.add_triangle(left_up, right_down, left_down, skin);
    Picture picture = Picture::of_size(320, 200);
    stage.look({});
    stage.draw(front, pose_at(100, 0, 0), picture.canvas());
    EXPECT_EQ(pixel_at(picture.canvas(), 130, 100), 0);
    stage.draw(behind, pose_at(150, 0, 0), picture.canvas());
    EXPECT_EQ(pixel_at(picture.canvas(), 130, 100), 200) << "a hole has no depth";
    EXPECT_EQ(pixel_at(picture.canvas(), 190, 100), 90);
}

TEST(LibraryStage, NothingOfTheLastPictureHidesTheNext) {
    Stage stage(grey_palette());
    Model square;
    add_square(square, 0, 50, 200);
    Picture picture = Picture::of_size(320, 200);
    stage.look({});
    stage.draw(square, pose_at(100, 0, 0), picture.canvas());
    clear(picture.canvas());
    stage.look({});
    stage.draw(square, pose_at(200, 0, 0), picture.canvas());
    EXPECT_EQ(pixel_at(picture.canvas(), 160, 100), 200);
}

TEST(LibraryStage, SideLightFollowsLambert) {
    Stage stage(grey_palette());
    Model square;
    add_square(square, 0, 50, 200);
    const auto grey_at = [&](std::int32_t x, std::int32_t z) {
        Picture picture = Picture::of_size(320, 200);
        stage.look({});
        stage.set_light(0, 256, x, 0, z);
        stage.draw(square, pose_at(100, 0, 0), picture.canvas());
        return static_cast<double>(pixel_at(picture.canvas(), 160, 100));
    };
    EXPECT_EQ(grey_at(-1, 0), 200);
    EXPECT_NEAR(grey_at(-1, 1), 200 * std::sqrt(0.5), 8);  // 64 shades
    EXPECT_NEAR(grey_at(1, 0), 0, 8);
}

// One that were copied would be destroyed twice.
template <class... Each>
constexpr bool can_none_be_copied =
    !(std::is_copy_assignable_v<Each> || ...) && !(std::is_copy_constructible_v<Each> || ...);
static_assert(can_none_be_copied<Window, Speaker, Model, Stage, LevelScene>);

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
    EXPECT_THROW(model.add_triangle({}, {}, {}, 0), std::runtime_error);
    EXPECT_THROW(Model("/nowhere/a.obj", grey_palette()), std::runtime_error);
    EXPECT_THROW(Model("/nowhere/a.obj", grey_palette(), 0), std::runtime_error);
}

}  // namespace
}  // namespace oblong::test
