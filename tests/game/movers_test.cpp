#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/input_error.h"
#include "game/simulation/collision.h"
#include "game/simulation/step.h"
#include "tests/game/toy_game.h"

namespace oblong {
namespace {

using test::floor_and;
using test::kAhead;
using test::kStand;
using test::Solid;
using test::ToyGame;
using test::ToyLevel;
using Phase = MoverState::Phase;

void activate_first(ToyGame& game) {
    Activations(game.level, game.state).activate({EntityRef::Kind::Mover, 0});
}

// A door across the way, 128 high, that goes up by 128 - 8.
ToyLevel with_door(std::vector<std::pair<std::string, std::string>> more = {}) {
    ToyLevel toy;
    toy.add_model(floor_and({})).add_model({{200, -64, 0, 216, 64, 128}});
    std::vector<std::pair<std::string, std::string>> door{{"classname", "func_door"}, {"model", "*1"}, {"angle", "-1"}};
    door.insert(door.end(), more.begin(), more.end());
    toy.add_entity(door);
    return toy;
}

TEST(Door, IsShutFarAwayAndOpensForWhoComesNear) {
    ToyGame game(with_door());
    game.play(35, kStand);
    EXPECT_EQ(game.state.movers[0].phase, Phase::AtStart);
    game.play(105, kAhead);
    EXPECT_GT(game.x(), 400);  // went through
}

TEST(Door, TakesAsLongAsItsSpeedSaysWaitsAndReturns) {
    ToyGame game(with_door({{"speed", "70"}, {"wait", "2"}}));
    activate_first(game);
    game.play(35, kStand);
    EXPECT_NEAR(game.travelled(0), 70, 0.1);
    game.play(25, kStand);  // 120 units at 2 a tick: 60 ticks
    EXPECT_EQ(game.state.movers[0].phase, Phase::AtEnd);
    EXPECT_NEAR(game.travelled(0), 120, 0.01);
    game.play(69, kStand);
    EXPECT_EQ(game.state.movers[0].phase, Phase::AtEnd);
    game.play(2 + 61, kStand);
    EXPECT_EQ(game.state.movers[0].phase, Phase::AtStart);
    EXPECT_EQ(game.travelled(0), 0);
}

TEST(Door, LipAndAngleSayHowFarAndWhither) {
    ToyGame game(with_door({{"angle", "270"}, {"lip", "28"}}));  // the first angle counts: up
    EXPECT_EQ(game.level.movers[0].legs.at(0).length, World::from_int(100));
    ToyLevel sideways;
    sideways.add_model(floor_and({})).add_model({{200, -64, 0, 216, 64, 128}});
    sideways.add_entity({{"classname", "func_door"}, {"model", "*1"}, {"angle", "270"}, {"lip", "28"}});
    ToyGame other(std::move(sideways));
    EXPECT_EQ(other.level.movers[0].legs.at(0).way.y, World::from_int(-100));
    EXPECT_EQ(other.level.movers[0].legs.at(0).way.x, World{});
}

TEST(Door, WaitOfMinusOneStaysOpen) {
    ToyGame game(with_door({{"wait", "-1"}}));
    activate_first(game);
    game.play(2000, kStand);
    EXPECT_EQ(game.state.movers[0].phase, Phase::AtEnd);
}

TEST(Door, ClosingOnThePlayerOpensAgain) {
    ToyGame game(with_door({{"wait", "0.1"}, {"speed", "400"}, {"spawnflags", "4"}}));
    game.level.movers[0].touch_box.reset();  // only activated by the test
    activate_first(game);
    game.play(12, kStand);
    game.state.player.position = Position{World::from_int(208), World{}, World::from_int(25)};
    for (int i = 0; i < 200; ++i) {
        game.play(1, kStand);
        ASSERT_GE(game.travelled(0), 56 - 1) << "would stand in the player, tick " << i;
    }
    EXPECT_NEAR(game.x(), 208, 0.01);
}

TEST(Door, TouchingDoorsOpenTogether) {
    ToyLevel toy;
    toy.add_model(floor_and({})).add_model({{200, -64, 0, 216, 0, 128}}).add_model({{200, 0, 0, 216, 64, 128}});
    toy.add_model({{1200, 0, 0, 1216, 64, 128}});
    for (const char* model : {"*1", "*2", "*3"})
        toy.add_entity({{"classname", "func_door"}, {"model", model}, {"angle", "-1"}});
    ToyGame game(std::move(toy));
    game.state.player.position = Position{World::from_int(160), World::from_int(-110), World::from_int(25)};
    game.play(1, kStand);  // near the first only
    EXPECT_EQ(game.state.movers[0].phase, Phase::Leaving);
    EXPECT_EQ(game.state.movers[1].phase, Phase::Leaving);
    EXPECT_EQ(game.state.movers[2].phase, Phase::AtStart);
}

TEST(Door, WithAButtonAnswersToItAlone) {
    ToyLevel toy = with_door({{"targetname", "gate"}});
    toy.add_model({{-80, -32, 0, -64, 32, 64}});
    toy.add_entity({{"classname", "func_button"}, {"model", "*2"}, {"angle", "180"}, {"target", "gate"}});
    ToyGame game(std::move(toy));
    game.play(70, kAhead);
    EXPECT_NEAR(game.x(), 184, 0.1);  // shut
    game.play(105, {-127, 0, 0, 0, 0});
    EXPECT_NE(game.state.movers[0].phase, Phase::AtStart);
}

// A plate of 128x128 that stands with its top at z = 8 below and 136 above.
ToyLevel with_lift() {
    ToyLevel toy;
    toy.add_model(floor_and({})).add_model({{100, -64, 0, 228, 64, 136}});
    toy.add_entity({{"classname", "func_plat"}, {"model", "*1"}, {"height", "128"}});
    return toy;
}

TEST(Lift, WaitsBelowCarriesThePlayerUpAndComesBack) {
    ToyGame game(with_lift());
    EXPECT_EQ(offset_of(game.level.movers[0], game.state.movers[0]).z, World::from_int(-128));
    game.play(16, kAhead);  // onto the plate
    for (int i = 0; i < 70; ++i) {
        game.play(1, kStand);
        ASSERT_GE(game.feet() + 0.01, game.travelled(0) + 8) << "sank into the plate, tick " << i;
    }
    EXPECT_NEAR(game.feet(), 136, 0.1);
    game.play(60, kAhead);  // off at the far end
    EXPECT_NEAR(game.feet(), 0, 0.1);
    game.play(35 * 6, kStand);
    EXPECT_EQ(game.travelled(0), 0);
}

TEST(Lift, CarriesThePlayerDownWithoutLettingGo) {
    ToyGame game(with_lift());
    game.play(16, kAhead);
    game.play(60, kStand);
    ASSERT_NEAR(game.feet(), 136, 0.1);
    game.level.movers[0].touch_box.reset();
    for (int i = 0; i < 35 * 5; ++i) {
        game.play(1, kStand);
        ASSERT_NEAR(game.feet(), game.travelled(0) + 8, 0.1) << "tick " << i;
    }
    EXPECT_EQ(game.travelled(0), 0);
}

TEST(Trigger, EndOfLevelEndsAndNothingMovesAfter) {
    ToyLevel toy;
    toy.add_model(floor_and({})).add_model({{300, -64, 0, 316, 64, 128}});
    toy.add_entity({{"classname", "trigger_changelevel"}, {"model", "*1"}});
    ToyGame game(std::move(toy));
    game.play(20, kAhead);
    EXPECT_FALSE(game.state.has_ended);
    game.play(60, kAhead);
    EXPECT_TRUE(game.state.has_ended);
    EXPECT_LT(game.x(), 320);
}

TEST(Trigger, TeleportsToItsTarget) {
    ToyLevel toy;
    toy.add_model(floor_and({})).add_model({{300, -64, 0, 316, 64, 128}});
    toy.add_entity({{"classname", "trigger_teleport"}, {"model", "*1"}, {"target", "there"}});
    toy.add_entity({{"classname", "info_teleport_destination"},
                    {"targetname", "there"},
                    {"origin", "-1000 500 0"},
                    {"angle", "90"}});
    ToyGame game(std::move(toy));
    game.play(40, kAhead);
    EXPECT_NEAR(game.x(), -1000, 1);
    EXPECT_GT(game.y(), 500);
    EXPECT_EQ(game.state.player.yaw, kQuarterTurn);
}

// A teleporter ahead that leads to (1000, 500, `exit_z`), with `more` keys.
ToyLevel with_teleporter(int exit_z, std::vector<std::pair<std::string, std::string>> more = {}) {
    ToyLevel toy;
    toy.add_model(floor_and({})).add_model({{100, -64, 0, 116, 64, 128}});
    std::vector<std::pair<std::string, std::string>> pairs{
        {"classname", "trigger_teleport"}, {"model", "*1"}, {"target", "there"}};
    pairs.insert(pairs.end(), more.begin(), more.end());
    toy.add_entity(pairs);
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
        ToyLevel toy;
        toy.add_model(floor_and({each.block})).add_model({{100, -64, 0, 116, 64, 128}});
        toy.add_entity({{"classname", "trigger_teleport"}, {"model", "*1"}, {"target", "there"}});
        toy.add_entity({{"classname", "info_teleport_destination"}, {"targetname", "there"}, {"origin", "1000 500 0"}});
        const GameLevel level = make_game_level(toy.level);
        const Position exit = level.triggers.at(0).place.position;
        const double dx = exit.x.raw / 4096.0 - each.x, dy = exit.y.raw / 4096.0 - each.y,
                     dz = exit.z.raw / 4096.0 - each.z;
        EXPECT_LE(std::sqrt(dx * dx + dy * dy + dz * dz), 2.01) << each.x << ' ' << each.y << ' ' << each.z;
    }
}

// Quake's rule: one with a name works for 0.2 s after it was activated, any other always.
TEST(Trigger, ATeleporterWithANameWorksOnlyWhenActivated) {
    ToyGame never(with_teleporter(0, {{"targetname", "gate"}}));
    never.play(35, kAhead);
    EXPECT_GT(never.x(), 116 + 16);
    EXPECT_LT(never.x(), 500);

    ToyLevel toy = with_teleporter(0, {{"targetname", "gate"}, {"spawnflags", "3"}});
    toy.add_model({{20, -64, 0, 70, 64, 128}});
    toy.add_entity({{"classname", "trigger_multiple"}, {"model", "*2"}, {"target", "gate"}});
    ToyGame game(std::move(toy));
    game.play(35, kAhead);
    EXPECT_NEAR(game.x(), 1000, 1);

    game.state = start_of(game.level);
    game.state.player.position.x = World::from_int(170);  // from behind the teleporter, past the trigger, and back
    game.play(40, {-127, 0, 0, 0, 0});
    EXPECT_LT(game.x(), 20);
    EXPECT_GT(game.x(), -300);
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
    game.level.movers[0].touch_box.reset();
    ASSERT_FALSE(is_out(game));
    game.play(1, kStand);
    EXPECT_TRUE(is_out(game));
    EXPECT_NEAR(game.x(), 0, 1);
}

// Doors, lifts and teleporters close together, with exits where doors and lifts pass.
ToyLevel crowded_room() {
    ToyLevel toy;
    toy.add_model(floor_and({{400, -400, 0, 420, 400, 400},
                             {-420, -400, 0, -400, 400, 400},
                             {-400, 400, 0, 400, 420, 400},
                             {-400, -420, 0, 400, -400, 400},
                             {-420, -420, 400, 420, 420, 440}}));
    int model = 0;
    const auto add = [&](const Solid& box, std::vector<std::pair<std::string, std::string>> pairs) {
        toy.add_model({box});
        pairs.emplace_back("model", "*" + std::to_string(++model));
        toy.add_entity(pairs);
    };
    for (const int side : {-1, 1}) {
        const int x = side * 200;
        add({x - 60, 100, 0, x + 60, 220, 64}, {{"classname", "func_plat"}, {"height", "56"}});
        add({x - 60, -220, 0, x + 60, -100, 96}, {{"classname", "func_door"}, {"angle", "-1"}, {"wait", "1"}});
        add({x - 20, -40, 0, x + 20, 40, 128},
            {{"classname", "func_door"}, {"angle", side < 0 ? "0" : "180"}, {"lip", "-60"}, {"wait", "0"}});
    }
    for (const char* exit : {"200 160 10", "-200 -160 20", "180 0 0"}) {
        const int x = model * 60 - 500;
        add({x, 300, 0, x + 30, 380, 64}, {{"classname", "trigger_teleport"}, {"target", exit}});
        toy.add_entity({{"classname", "info_teleport_destination"}, {"targetname", exit}, {"origin", exit}});
    }
    return toy;
}

TEST(Mover, HoldsThePlayerInNoneOfManyTicks) {
    ToyGame game(crowded_room());
    std::uint32_t seed = 1;
    TickInput input = kAhead;
    int inside = 0, teleports = 0;
    for (int tick = 0; tick < 50'000; ++tick) {
        seed = seed * 1'664'525 + 1'013'904'223;
        input.buttons = (seed >> 12) % 8 == 0 ? kJumpButton : std::uint8_t{0};
        if ((seed >> 16) % 25 == 0) input.yaw = static_cast<std::int16_t>(static_cast<int>(seed >> 20) % 3000 - 1500);
        const double before = game.x();
        game.play(1, input);
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
        ToyLevel toy = with_door({{"lip", "-32768"}});
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
        EXPECT_EQ(level.walls[0].model, ModelIndex(1));
    }
}

// As many of each class as no level has; each step of making the level and of a tick passes over them once.
TEST(GameLevel, TensOfThousandsOfEntities) {
    constexpr int kCount = 8000;
    ToyLevel toy;
    toy.add_model(floor_and({}));
    for (int i = 0; i < kCount; ++i) {
        const std::string name = std::to_string(i), model = "*" + std::to_string(i + 1);
        SubModel box;
        box.box = {{3 * i, 0, 0}, {3 * i + 3, 10, 64}};
        toy.level.models.push_back(box);
        toy.add_entity({{"classname", "func_door"}, {"model", model}, {"angle", "-1"}});
        toy.add_entity({{"classname", "func_button"}, {"model", model}, {"targetname", "all"}, {"target", "all"}});
        toy.add_entity({{"classname", "trigger_once"}, {"model", model}, {"target", "all"}});
        toy.add_entity(
            {{"classname", "trigger_teleport"}, {"model", model}, {"targetname", "t" + name}, {"target", "t" + name}});
        toy.add_entity({{"classname", "func_wall"}, {"model", model}});
    }
    ToyGame game(std::move(toy));
    ASSERT_EQ(game.level.movers.size(), 2u * kCount);
    EXPECT_EQ(game.level.triggers.size(),
              1u * kCount);  // teleporters have no exit: none of their targets has an origin
    EXPECT_EQ(game.level.movers.front().touch_box->maxs.x, World::from_int(3 * kCount - 5 + 65));  // linked, end to end
    game.play(5, kStand);
    EXPECT_NE(game.state.movers.back().phase, Phase::AtStart);
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
}  // namespace oblong
