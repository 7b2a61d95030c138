#include "game/movers.h"

#include <gtest/gtest.h>

#include "tests/game/toy_game.h"

namespace oblong {
namespace {

using test::floor_and;
using test::kAhead;
using test::kStand;
using test::ToyGame;
using test::ToyLevel;
using Phase = MoverState::Phase;

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
    set_off(game.stage, game.state, 0);
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
    EXPECT_EQ(game.stage.movers[0].length, World::from_int(100));
    ToyLevel sideways;
    sideways.add_model(floor_and({})).add_model({{200, -64, 0, 216, 64, 128}});
    sideways.add_entity({{"classname", "func_door"}, {"model", "*1"}, {"angle", "270"}, {"lip", "28"}});
    ToyGame other(std::move(sideways));
    EXPECT_EQ(other.stage.movers[0].way.y, World::from_int(-100));
    EXPECT_EQ(other.stage.movers[0].way.x, World{});
}

TEST(Door, WaitOfMinusOneStaysOpen) {
    ToyGame game(with_door({{"wait", "-1"}}));
    set_off(game.stage, game.state, 0);
    game.play(2000, kStand);
    EXPECT_EQ(game.state.movers[0].phase, Phase::AtEnd);
}

TEST(Door, ClosingOnThePlayerOpensAgain) {
    ToyGame game(with_door({{"wait", "0"}, {"speed", "400"}, {"spawnflags", "4"}}));
    game.stage.movers[0].touch.reset();  // only set off by hand here
    set_off(game.stage, game.state, 0);
    game.play(12, kStand);
    game.state.player.place = Place{World::from_int(208), World{}, World::from_int(25)};
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
    game.state.player.place = Place{World::from_int(160), World::from_int(-110), World::from_int(25)};
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
    EXPECT_EQ(offset_of(game.stage.movers[0], game.state.movers[0]).z, World::from_int(-128));
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
    game.stage.movers[0].touch.reset();
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

// Entities are text from anywhere: none may bring the game down.
TEST(Stage, HostileEntitiesAreHarmless) {
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
TEST(Stage, BoxesAndPlacesOutsideTheWorldAreHarmless) {
    for (const std::int32_t far : {40'000, 999'999, 1 << 20}) {
        const std::string place = std::to_string(far / 2 - 1) + " 0 " + std::to_string(far / 2 - 1);
        ToyLevel toy;
        toy.add_model(floor_and({}))
            .add_model({{-far, -far, -far, far, far, far}})
            .add_model({{far, far, far, -far, -far, -far}});
        toy.add_entity({{"classname", "info_player_start"}, {"origin", place}});
        toy.add_entity({{"classname", "info_teleport_destination"}, {"targetname", "self"}, {"origin", place}});
        for (const char* name : {"func_door", "func_plat", "func_button", "trigger_teleport", "func_wall"})
            for (const char* model : {"*1", "*2"})
                toy.add_entity(
                    {{"classname", name}, {"model", model}, {"angle", "45"}, {"lip", "-32768"}, {"target", "self"}});
        ToyGame game(std::move(toy));
        game.play(100, kAhead);
        EXPECT_EQ(game.state.tick, 100);
    }
}

}  // namespace
}  // namespace oblong
