#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/library/hall.h"
#include "tests/support/refusal.h"

namespace oblong::test {
namespace {

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
    std::vector<bool> is_red;
    for (const std::uint8_t pixel : hall.picture(pose_at(-200, 0, 100), time_ms))
        is_red.push_back(pixel == 3 || pixel >= 192);
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
    EXPECT_EQ(start, (Pose{-100 * 256 - 128, 20 * 256 + 64, (32 + 1 + 22) * 256 + 32, 22 * 256 + 128, 0, 0}));
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
    const TemporaryFolder folder;
    const std::string file = folder.write("broken.bsp", std::string("nothing"));
    EXPECT_TRUE(said([&] { LevelScene(file, grey_palette()); }).starts_with(file + ": "));
}

TEST(LibraryLevel, ModelIsShownOnceAlsoIfItIsGoneByThen) {
    Hall hall;
    const Pose eye = pose_at(-100, 0, 46), place = pose_at(100, 0, 46);
    const auto empty = hall.picture(eye);
    hall.level.show(square_of(30, 3), place);  // it is gone then
    const Model other = square_of(10, 200);    // where that was
    const auto shown = hall.picture(eye);
    const Model kept = square_of(30, 3);
    hall.level.show(kept, place);
    EXPECT_NE(shown, empty);
    EXPECT_EQ(hall.picture(eye), shown);
    EXPECT_EQ(hall.picture(eye), empty);
}

}  // namespace
}  // namespace oblong::test
