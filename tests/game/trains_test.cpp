#include <gtest/gtest.h>

#include "tests/game/logic_level.h"
#include "tests/game/scenario.h"

namespace oblong {
namespace {

// Plates of 128x128x16 whose least corner goes round a square of 400 units from (300, 0, 100), at 200 a second. It
// stands at (-600, -600, 100) in the level: an offset of 900 600 is at the first corner.
constexpr test::Scenario kTrains[] = {
    {"StartAtTheirFirstCornerGoRoundAndWaitWhereTheyAreTold", R"(
        + func_train -600 -600 100 -472 -472 116 target=a speed=200
        + path_corner targetname=a target=b origin="300 0 100"
        + path_corner targetname=b target=c origin="700 0 100" wait=2
        + path_corner targetname=c target=d origin="700 400 100"
        + path_corner targetname=d target=a origin="300 400 100"
        : ox0 = 900, oy0 = 600, oz0 = 0
        wait 7: ox0 = 900, oy0 = 600        # they look for their corners first
        wait 35: ox0 = 1100 +- 0.1
        wait 36: ox0 = 1300, oy0 = 600
        wait 69: ox0 = 1300, oy0 = 600      # two seconds
        wait 35: oy0 = 800 +- 6
        wait 186: ox0 = 900 +- 6, oy0 = 600 +- 12       # a tenth of a second at each of the other corners
        wait 35: ox0 > 1000                 # and round again
    )"},
    {"WithANameStandUntilTheyAreActivated", R"(
        + func_train -600 -600 100 -472 -472 116 targetname=train target=a speed=200
        + path_corner targetname=a target=b origin="300 0 100"
        + path_corner targetname=b target=a origin="700 0 100"
        + trigger_multiple -1000 -50 0 -950 50 64 target=train
        wait 100: ox0 = 900, oy0 = 600, oz0 = 0, active = 0
        stand -970 0; wait 36: ox0 = 1100 +- 12
        stand -970 0; wait 2: phase0 = leaving      # activated again, it goes on
    )"},
    {"StopAtACornerWithoutANext", R"(
        + func_train -600 -600 100 -472 -472 116 target=a speed=200
        + path_corner targetname=a target=b origin="300 0 100"
        + path_corner targetname=b target=nowhere origin="300 400 100"
        wait 1050: ox0 = 900, oy0 = 1000, oz0 = 0, active = 0
    )"},
    {"CarryThePlayer", R"(
        + func_train -600 -600 100 -472 -472 116 target=a speed=200
        + path_corner targetname=a target=b origin="300 0 100"
        + path_corner targetname=b target=c origin="700 0 100" wait=2
        + path_corner targetname=c target=a origin="700 400 100"
        at 364 64 116
        each 208: x = ox0+-536 +- 0.2, y = oy0+-536 +- 0.2, feet = 116 +- 0.2       # 64 from the corner
        : x > 700, y > 300
    )"},
    {"PushThePlayerAndWaitWhereThereIsAWallBehind", R"(
        + func_train -600 -600 0 -472 -472 100 target=a speed=200
        + path_corner targetname=a target=b origin="300 0 0"
        + path_corner targetname=b target=a origin="700 0 0" wait=-1
        + func_wall 700 -100 0 720 200 200
        at 500 64; play 200: phase0 = leaving
        : x = 684 +- 5.7, travelled0 = 240 +- 6     # against the wall, but for a tick's way
        play 35: phase0 = leaving, travelled0 = 240 +- 6
        wait 100: phase0 = end
    )"},
    {"WithoutCornersStandWhereTheyAre", R"(
        + func_train 300 -64 0 400 64 100 target=nowhere
        : all_movers = 0, all_walls = 1
    )"},
};
OBLONG_SCENARIOS(Trains, kTrains);

TEST(Train, CornersInHostileOrderAreHarmless) {
    test::LogicLevel level;
    for (const char* first : {"self", "far", "pair"})
        level.add("func_train", {300, -64, 0, 400, 64, 100}, {{"target", first}, {"speed", "1e9"}});
    level.add("path_corner", {{"targetname", "self"}, {"target", "self"}, {"origin", "0 0 0"}, {"wait", "99999999"}});
    level.add("path_corner", {{"targetname", "far"}, {"target", "end"}, {"origin", "32768 32768 32768"}});
    level.add("path_corner", {{"targetname", "end"}, {"target", "far"}, {"origin", "-32768 -32768 -32768"}});
    level.add("path_corner", {{"targetname", "pair"}, {"target", "pair2"}, {"origin", "5 5 5"}});
    level.add("path_corner", {{"targetname", "pair2"}, {"target", "pair2"}, {"origin", "5 5 5"}});
    test::LogicGame game(level);
    game.wait(500);
    EXPECT_EQ(game.state.tick, 500);
}

TEST(Train, GoesAsFarAsThe4096thCornerOfAnEndlessChain) {
    test::LogicLevel source;
    source.add("func_train", {-600, -600, 100, -472, -472, 116}, {{"target", "c0"}});
    for (int i = 0; i < 5000; ++i)
        source.add("path_corner", {{"targetname", "c" + std::to_string(i)},
                                   {"target", "c" + std::to_string(i + 1)},
                                   {"origin", std::to_string(i % 100) + " 0 100"}});
    EXPECT_EQ(test::LogicGame(source).level.movers[0].legs.size(), 4095u);
}

}  // namespace
}  // namespace oblong
