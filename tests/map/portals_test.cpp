#include <gtest/gtest.h>

#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

// A room whose north wall leaves a gap from x = 128 on.
std::string room_with_gap(double gap) {
    const std::string begins_at_minus_1 = box({-1, 256, 0}, {272, 272, 128});
    const std::string east = replaced(begins_at_minus_1, "( -1 ", "( " + std::to_string(128 + gap) + " ");
    return box({-16, -16, -16}, {272, 272, 0}) + box({-16, -16, 128}, {272, 272, 144}) +
           box({-16, 0, 0}, {0, 256, 128}) + box({256, 0, 0}, {272, 256, 128}) + box({-16, -16, 0}, {272, 0, 128}) +
           box({-16, 256, 0}, {128, 272, 128}) + east;
}

TEST(Leak, NamesTheEntityAndTheWayOut) {
    const std::string source = level(room({0, 0, 0}, {256, 256, 128}),
                                     entity_at("info_player_start", {128, 128, 32}) + entity_at("light", {400, 0, 0}));
    try {
        compile(source, {true});
        FAIL() << "the light outside should leak";
    } catch (const map::LeakError& leak) {
        EXPECT_NE(std::string(leak.what()).find("light at 400 0 0 is outside of the level"), std::string::npos)
            << leak.what();
    }
    try {
        compile(level(room({0, 0, 0}, {256, 256, 128}), entity_at("light", {400, 0, 0})), {true});
        FAIL() << "the light outside should leak";
    } catch (const map::LeakError& leak) {
        EXPECT_NE(std::string(leak.what()).find("the level leaks: light at 400 0 0"), std::string::npos)
            << leak.what() << ": no start says which side is inside";
    }
}

TEST(Leak, ThePathLeadsThroughTheHole) {
    const std::string closed = room({0, 0, 0}, {256, 256, 128});
    const std::string open = closed.substr(0, closed.rfind("{"));  // without the wall at y = 256
    try {
        compile(level(open, entity_at("info_player_start", {128, 128, 32})), {true});
        FAIL() << "a room of five walls should leak";
    } catch (const map::LeakError& leak) {
        ASSERT_GE(leak.path.size(), 2u);
        EXPECT_EQ(leak.path.front(), (Point{128, 128, 32}));
        EXPECT_GT(leak.path.back().y, 256);
        EXPECT_EQ(map::points_text({{1, 2.5, -3}, {4, 5, 6}}), "1 2.5 -3\n4 5 6");
    }
    EXPECT_NO_THROW(compile(level(closed, entity_at("info_player_start", {128, 128, 32})), {true}));
}

// The room's walls reach from -16 to 272, 272 and 144.
TEST(Leak, OnTheOuterSurfaceOfAWallIsInside) {
    const auto leaks = [](const Whole& origin) {
        try {
            compile(level(plain_room(), lights_of_plain_room() + entity_at("path_corner", origin)), {true});
        } catch (const map::LeakError&) {
            return true;
        }
        return false;
    };
    const std::vector<Whole> on_surfaces{{-16, 99, 9},  {272, 99, 9},   {99, -16, 9},    {99, 272, 9}, {99, 99, -16},
                                         {99, 99, 144}, {-16, -16, 50}, {272, 272, 144}, {0, 99, 9},   {-16, -16, -16}};
    for (const Whole& origin : on_surfaces) EXPECT_FALSE(leaks(origin)) << origin[0] << ' ' << origin[1];
    for (const Whole& origin : {Whole{-17, 99, 9}, {273, 99, 9}, {99, 99, -17}, {99, 99, 145}, {-16, 99, 200}})
        EXPECT_TRUE(leaks(origin)) << origin[0] << ' ' << origin[1];
}

TEST(Leak, OneOnTheFloorFindsAHole) {
    const std::string open = plain_room().substr(0, plain_room().rfind("{"));
    EXPECT_THROW(compile(level(open, entity_at("info_player_start", {128, 128, 0})), {true}), map::LeakError);
}

TEST(Leak, GapsLeakUnlessTheyAreRounding) {
    for (const double gap : {8.0, 1.0, 0.25, 0.05}) {
        const std::string source = level(room_with_gap(gap), lights_of_plain_room());
        EXPECT_THROW(compile(source, {true}), map::LeakError) << gap;
    }
    for (const double gap : {0.01, 0.001, 0.0001, 0.0}) {
        const auto bsp = compile(level(room_with_gap(gap), lights_of_plain_room()), {true});
        EXPECT_EQ(first_fault_of_rays(bsp, 1000, 5), "") << gap;
    }
}

}  // namespace
}  // namespace oblong::test
