#include <gtest/gtest.h>

#include "engine/files/files.h"
#include "engine/level/bsp_read.h"
#include "tests/demo/visitor.h"
#include "tests/support/folders.h"

namespace oblong::test::walk_test {
namespace {

class DemoWalk : public testing::Test {
  protected:
    void walk(const std::vector<test::Waypoint>& route) { visitor_.walk(route); }

    const Level level_ = read_bsp(read_file(test::build_folder() + "/assets/demo.bsp"));
    test::Visitor visitor_{level_};
};

const std::vector<test::Waypoint> kEntranceToGallery{{0, -16}, {0, 200}, {200, 416}, {400, 416}};
const std::vector<test::Waypoint> kCourtyardToTower{
    {512, 1420},  {-60, 1600},  {-200, 1600}, {-290, 1590}, {-500, 1584}, {-720, 1584}, {-792, 1620},
    {-792, 2128}, {-792, 2320}, {-80, 2320},  {512, 2320},  {512, 2200},  {512, 1900}};

TEST_F(DemoWalk, ThroughTheDoorUpTheLiftAndDownTheStairsToTheTower) {
    walk(kEntranceToGallery);
    walk({{1290, 416}, {1400, 416}, {1488, 560}, {1488, 700}, {1400, 760}, {1400, 888}, {1320, 888}});
    constexpr double kStandingOnTheBalcony = 160 + 24;
    walk({{1248, 888, kStandingOnTheBalcony - 1}, {1100, 888}, {1112, 1030}, {1112, 1300}, {1060, 1400}, {700, 1390}});
    walk(kCourtyardToTower);
}

TEST_F(DemoWalk, TheTowerIsShutAtBothGatesWhileLensesAreMissing) {
    walk(kEntranceToGallery);
    walk({{736, 416}, {736, 560}, {512, 760}, {512, 1160}, {512, 1360}, {512, 1540}});
    EXPECT_FALSE(visitor_.walk_to({512, 1640})) << "from the courtyard";
    walk({{512, 1420}});
    walk(kCourtyardToTower);
    EXPECT_FALSE(visitor_.walk_to({512, 1800})) << "from the corridor";
}

TEST_F(DemoWalk, ThroughTheRainAndTheFogAndByTheTeleporterToTheTower) {
    walk(kEntranceToGallery);
    walk({{736, 416}, {736, 560}, {512, 760}, {512, 1160}, {512, 1360}});
    walk({{740, 1430}, {1000, 1616}, {1230, 1616}, {1230, 1776}, {1392, 1776}, {1392, 1870}, {1392, 2240}});
    constexpr double kInTheGarden = -208 + 24;
    EXPECT_NEAR(number_of(visitor_.state().player.position.z), kInTheGarden, 1.5);
    while (number_of(visitor_.state().player.position.y) > 1800) ASSERT_TRUE(visitor_.step_to(1392, 2600));
    EXPECT_NEAR(number_of(visitor_.state().player.position.x), 40, 20) << "before the room of forced perspective";
    walk({kCourtyardToTower.begin() + 2, kCourtyardToTower.end()});
}

TEST_F(DemoWalk, WhoFallsIntoTheLavaCanClimbOutAtBothEndsOfBothPits) {
    constexpr double kStandingOnTheFloor = 48 + 24, kInLava = 48;
    walk(kEntranceToGallery);
    walk({{736, 416}, {736, 560}, {512, 760}, {512, 1160}, {512, 1360}});
    walk({kCourtyardToTower.begin(), kCourtyardToTower.begin() + 9});
    for (const double y : {2432.0, 2236.0}) {
        for (const double x : {-780.0, -160.0}) {
            walk({{-472, 2320, kStandingOnTheFloor - 1}, {-472, y}});
            ASSERT_NE(visitor_.state().player.depth, Depth::Dry) << y;
            ASSERT_LT(number_of(visitor_.state().player.position.z), kInLava) << y;
            walk({{x, y, kStandingOnTheFloor - 1}, {x, 2320}});
            EXPECT_EQ(visitor_.state().player.depth, Depth::Dry) << x << ' ' << y;
        }
    }
}

}  // namespace
}  // namespace oblong::test::walk_test
