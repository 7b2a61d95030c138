#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/input_error.h"
#include "game/simulation/collision.h"
#include "tests/game/logic_level.h"
#include "tests/game/scenario.h"

namespace oblong::test::movers_test {
namespace {

// Plates of 128x128x16 whose least corner goes round a square of 400 units from (300, 0, 100), at 200 a second. It
// stands at (-600, -600, 100) in the level: an offset of 900 600 is at the first corner.
constexpr Scenario kTrains[] = {
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
    {"GoOnFromACornerWhenTheyAreActivated", R"(
        + func_train -600 -600 100 -472 -472 116 targetname=train target=a speed=200
        + path_corner targetname=a target=b origin="300 0 100"
        + path_corner targetname=b target=c origin="700 0 100" wait=-1
        + path_corner targetname=c target=nowhere origin="700 400 100"
        + trigger_multiple -1000 -50 0 -950 50 64 target=train
        stand -970 0; wait 300: ox0 = 1300, oy0 = 600, active = 0
        stand -970 0; wait 300: ox0 = 1300, oy0 = 1000, active = 0
        stand -970 0; wait 10: ox0 = 1300, oy0 = 1000, active = 0      # there is no next corner
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
    {"GoAsFarAsThe4096thCornerOfAnEndlessChain", R"(
        + func_train -600 -600 100 -472 -472 116 target=c0
        + 5000x path_corner targetname=c{0+1i} target=c{1+1i} origin="{0+1i} 0 100"
        : legs0 = 4095
    )"},
    {"GoOnWhateverTheOrderOfTheirCorners", R"(
        + func_train 300 -64 0 400 64 100 target=self speed=1e9
        + func_train 300 -64 0 400 64 100 target=far speed=1e9
        + func_train 300 -64 0 400 64 100 target=pair speed=1e9
        + path_corner targetname=self target=self origin="0 0 0" wait=99999999
        + path_corner targetname=far target=end origin="32768 32768 32768"
        + path_corner targetname=end target=far origin="-32768 -32768 -32768"
        + path_corner targetname=pair target=pair2 origin="5 5 5"
        + path_corner targetname=pair2 target=pair2 origin="5 5 5"
        wait 500: tick = 500
    )"},
    {"WithoutCornersStandWhereTheyAre", R"(
        + func_train 300 -64 0 400 64 100 target=nowhere
        : all_movers = 0, all_walls = 1
    )"},
};
OBLONG_SCENARIOS(Trains, kTrains);

using Phase = MoverState::Phase;

// A door across the way, 128 high, that goes up by 128 - 8 unless it is said to go elsewhere.
ToyLevel with_door(const char* lip = "8") {
    ToyLevel toy;
    toy.add_model(floor_and({})).add_model({{200, -64, 0, 216, 64, 128}});
    toy.add_entity({{"classname", "func_door"}, {"model", "*1"}, {"angle", "-1"}, {"lip", lip}});
    return toy;
}

// A teleporter ahead that leads to (1000, 500, `exit_z`), and blocks of the world.
ToyLevel with_teleporter(int exit_z, std::vector<Solid> blocks = {}) {
    ToyLevel toy;
    toy.add_model(floor_and(std::move(blocks))).add_model({{100, -64, 0, 116, 64, 128}});
    toy.add_entity({{"classname", "trigger_teleport"}, {"model", "*1"}, {"target", "there"}});
    toy.add_entity({{"classname", "info_teleport_destination"},
                    {"targetname", "there"},
                    {"origin", "1000 500 " + std::to_string(exit_z)},
                    {"angle", "90"}});
    return toy;
}

// The exit, at (1000, 500, 27), is in a block of the world: the nearest place out of it is taken, whichever side it is
// on.
TEST(Trigger, ATeleporterIntoRockLeadsBesideIt) {
    struct Case {
        Solid block;
        double x, y, z;  // where the player's middle is free: 16 units from a side, 24 above a floor
    };
    for (const Case& each : {Case{{900, 400, 0, 1100, 520, 400}, 1000, 536, 27},
                             {{900, 490, 0, 1100, 620, 400}, 1000, 474, 27},
                             {{990, 400, 0, 1200, 600, 400}, 974, 500, 27},
                             {{800, 400, 0, 1010, 600, 400}, 1026, 500, 27},
                             {{800, 300, 0, 1200, 700, 40}, 1000, 500, 64}}) {
        const ToyLevel toy = with_teleporter(0, {each.block});
        const GameLevel level = make_game_level(toy.level);
        const Position exit = level.triggers.at(0).place.position;
        const double dx = exit.x.raw / 4096.0 - each.x, dy = exit.y.raw / 4096.0 - each.y,
                     dz = exit.z.raw / 4096.0 - each.z;
        EXPECT_LE(std::sqrt(dx * dx + dy * dy + dz * dz), 2.01) << each.x << ' ' << each.y << ' ' << each.z;
    }
}

bool is_out(const ToyGame& game) {
    return is_free(game.level, game.state, game.state.player.position);
}

// A column that fills its shaft: a teleporter's exit is deep inside it.
TEST(Mover, WhoIsTeleportedIntoOneIsPushedOutTheShortestWay) {
    ToyLevel toy = with_teleporter(20);
    toy.add_model({{960, 380, 0, 1040, 560, 128}});
    toy.add_entity({{"classname", "func_door"}, {"model", "*2"}, {"angle", "-2"}, {"targetname", "shut"}});
    toy.add_entity({{"classname", "func_door"}, {"model", "*2"}, {"target", "shut"}, {"spawnflags", "4"}});
    ToyGame game(std::move(toy));
    for (int tick = 0; tick < 35; ++tick) {
        game.play(1, game.x() < 500 ? kAhead : kStand);
        if (game.x() > 500 && !is_out(game)) {
            game.play(1, kStand);
            ASSERT_TRUE(is_out(game)) << "tick " << tick;
        }
    }
    EXPECT_NEAR(std::abs(game.x() - 1000), 40 + 16 + 2, 1);
}

TEST(Mover, WhoIsInsideOneWithoutAWayOutStartsAgain) {
    ToyLevel toy;  // a shaft with walls and a lid, filled by a door
    toy.add_model(floor_and({{900, 400, 0, 940, 600, 300},
                             {1060, 400, 0, 1100, 600, 300},
                             {900, 360, 0, 1100, 400, 300},
                             {900, 600, 0, 1100, 640, 300},
                             {900, 360, 200, 1100, 640, 300}}));
    toy.add_model({{940, 400, 0, 1060, 600, 200}});
    toy.add_entity({{"classname", "func_door"}, {"model", "*1"}, {"angle", "-2"}, {"targetname", "shut"}});
    toy.add_entity({{"classname", "func_button"}, {"model", "*1"}, {"target", "shut"}});
    ToyGame game(std::move(toy));
    game.state.player.position = {World::from_int(1000), World::from_int(500), World::from_int(100)};
    game.level.movers[0].touch.box.reset();
    ASSERT_FALSE(is_out(game));
    game.play(1, kStand);
    EXPECT_TRUE(is_out(game));
    EXPECT_NEAR(game.x(), 0, 1);
}

// Doors, lifts and teleporters close together, with exits where doors and lifts pass.
ToyLevel crowded_room() {
    LogicLevel level({{400, -400, 0, 420, 400, 400},
                      {-420, -400, 0, -400, 400, 400},
                      {-400, 400, 0, 400, 420, 400},
                      {-400, -420, 0, 400, -400, 400},
                      {-420, -420, 400, 420, 420, 440}});
    for (const int side : {-1, 1}) {
        const int x = side * 200;
        level.add("func_plat", {x - 60, 100, 0, x + 60, 220, 64}, {{"height", "56"}});
        level.add("func_door", {x - 60, -220, 0, x + 60, -100, 96}, {{"angle", "-1"}, {"wait", "1"}});
        level.add("func_door", {x - 20, -40, 0, x + 20, 40, 128},
                  {{"angle", side < 0 ? "0" : "180"}, {"lip", "-60"}, {"wait", "0"}});
    }
    int x = -140;
    for (const char* exit : {"200 160 10", "-200 -160 20", "180 0 0"}) {
        level.add("trigger_teleport", {x, 300, 0, x + 30, 380, 64}, {{"target", exit}});
        level.add("info_teleport_destination", {{"targetname", exit}, {"origin", exit}});
        x += 60;
    }
    return level.take();
}

TEST(Mover, HoldsThePlayerInNoneOfManyTicks) {
    ToyGame game(crowded_room());
    RandomRun run;
    int inside = 0, teleports = 0;
    for (int tick = 0; tick < 50'000; ++tick) {
        const double before = game.x();
        game.play(1, run.next());
        teleports += std::abs(game.x() - before) > 50;
        inside = is_out(game) ? 0 : inside + 1;
        ASSERT_LE(inside, 1) << "tick " << tick << " at " << game.x() << ' ' << game.y() << ' ' << game.feet();
    }
    EXPECT_GT(teleports, 30);
}

// Entities are text from anywhere: none may bring the game down.
TEST(GameLevel, HostileEntitiesAreHarmless) {
    ToyLevel toy;
    toy.add_model(floor_and({})).add_model({{200, -64, 0, 216, 64, 128}});
    for (const char* name : {"func_door", "func_plat", "func_button", "trigger_teleport", "func_wall"})
        for (const char* model : {"*1", "*0", "*-1", "*99999999999", "*", "", "maps/b.bsp"})
            toy.add_entity({{"classname", name},
                            {"model", model},
                            {"angle", "1e30"},
                            {"angles", "99999999 99999999 99999999"},
                            {"speed", "-99999999999"},
                            {"wait", "999999999"},
                            {"lip", "-99999999"},
                            {"height", "nan"},
                            {"target", "self"},
                            {"targetname", "self"}});
    ToyGame game(std::move(toy));
    game.play(200, kAhead);
    EXPECT_EQ(game.state.tick, 200);
}

// A model's box is any number of the file: empty models of some compilers are inside out, damaged ones anywhere.
TEST(GameLevel, BoxesAndPositionsOutsideTheWorldAreHarmless) {
    for (const std::int32_t far : {40'000, 999'999, 1 << 20}) {
        const std::string position = std::to_string(far / 2 - 1) + " 0 " + std::to_string(far / 2 - 1);
        ToyLevel toy;
        toy.add_model(floor_and({}))
            .add_model({{-far, -far, -far, far, far, far}})
            .add_model({{far, far, far, -far, -far, -far}});
        toy.add_entity({{"classname", "info_player_start"}, {"origin", position}});
        toy.add_entity({{"classname", "info_teleport_destination"}, {"targetname", "self"}, {"origin", position}});
        for (const char* name : {"func_door", "func_plat", "func_button", "trigger_teleport", "func_wall"})
            for (const char* model : {"*1", "*2"})
                toy.add_entity(
                    {{"classname", name}, {"model", model}, {"angle", "45"}, {"lip", "-32768"}, {"target", "self"}});
        ToyGame game(std::move(toy));
        game.play(100, kAhead);
        EXPECT_EQ(game.state.tick, 100);
    }
}

// A vertex that is moved along with its model must stay in the format of world coordinates (+-524,288 units).
TEST(GameLevel, AMoverThatWouldLeaveTheFormatStandsStill) {
    const auto movers_with_vertex = [](World x) {
        ToyLevel toy = with_door("-32768");
        toy.level.vertices.push_back({x, World{}, World{}});
        return make_game_level(toy.level);
    };
    const World travel = World::from_int(128 + 32'768);
    EXPECT_EQ(movers_with_vertex(World::from_int(4096)).movers.at(0).legs.at(0).length, travel);
    EXPECT_EQ(movers_with_vertex(World::highest() - travel - World::ulp()).movers.size(), 1u);
    for (const World x : {World::highest() - travel, World::highest(), World::lowest()}) {
        const GameLevel level = movers_with_vertex(x);
        EXPECT_TRUE(level.movers.empty());
        ASSERT_EQ(level.walls.size(), 1u);
        EXPECT_EQ(level.walls[0], ModelIndex(1));
    }
}

TEST(GameLevel, TooManyMoversAreRefused) {
    ToyLevel toy = with_door();
    toy.level.entities.front().pairs.front() = {"classname", "func_button"};  // the first value of a key counts
    while (toy.level.entities.size() < kMostMovers) toy.level.entities.push_back(toy.level.entities.front());
    EXPECT_EQ(make_game_level(toy.level).movers.size(), kMostMovers);
    toy.level.entities.push_back(toy.level.entities.front());
    EXPECT_THROW(make_game_level(toy.level), InputError);
}

}  // namespace
}  // namespace oblong::test::movers_test
