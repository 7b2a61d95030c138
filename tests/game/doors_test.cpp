#include <gtest/gtest.h>

#include <array>
#include <string>

#include "game/simulation/collision.h"
#include "tests/game/logic_level.h"

namespace oblong {
namespace {

using test::kStand;
using test::LogicGame;
using test::LogicLevel;
using test::Pairs;
using test::Solid;
using Phase = MoverState::Phase;

constexpr Solid kPanel{200, -64, 0, 216, 64, 128};  // travels 120 upwards: 42 ticks at 100 a second
constexpr Solid kVolume{-1000, -50, 0, -950, 50, 64};

LogicLevel with_door(Pairs pairs) {
    LogicLevel level;
    pairs.insert(pairs.begin(), {"angle", "-1"});
    level.add("func_door", kPanel, pairs);
    return level;
}

void touch_trigger(LogicGame& game) {
    game.stand_at(-970, 0);
    game.wait(1);
}

TEST(Door, WithAKeyOpensToWhoHasItForGoodAndTakesIt) {
    for (const auto& [flag, item, said] : {std::array{"16", "item_key1", "You need the silver key"},
                                           std::array{"8", "item_key2", "You need the gold key"}}) {
        LogicLevel level = with_door({{"spawnflags", flag}, {"wait", "1"}});
        level.add(item, {{"origin", "-600 0 24"}});
        level.add(item == std::string("item_key1") ? "item_key2" : "item_key1", {{"origin", "-600 400 24"}});
        LogicGame game(level);
        game.stand_at(-600, 400);  // the other key
        const std::string before = game.message();
        game.stand_at(150, 0);
        EXPECT_EQ(game.message(), before) << "from afar it says nothing";
        game.stand_at(183, 0);
        EXPECT_EQ(game.message(), said);
        EXPECT_FALSE(game.has_left(0));
        game.stand_at(-600, 0);
        EXPECT_EQ(game.state.keys, kSilverKey | kGoldKey);
        game.wait(70);
        game.stand_at(183, 0);
        EXPECT_TRUE(game.has_left(0));
        EXPECT_EQ(game.state.keys, flag == std::string("16") ? kGoldKey : kSilverKey);
        game.wait(35 * 20);
        EXPECT_EQ(game.phase(0), Phase::AtEnd);
    }
}

TEST(Door, ThatSomethingActivatesSaysItsMessageToWhoTouchesItUntilItOpens) {
    LogicLevel level = with_door({{"targetname", "door"}, {"message", "Find the switch"}, {"wait", "1"}});
    level.add("trigger_multiple", kVolume, {{"target", "door"}});
    LogicGame game(level);
    game.stand_at(183, 0);
    EXPECT_EQ(game.message(), "Find the switch");
    EXPECT_EQ(game.state.message_tick, 1);
    game.put_at(183, 0);
    game.play(69, kStand);
    EXPECT_EQ(game.state.message_tick, 1);
    game.play(1, kStand);
    EXPECT_EQ(game.state.message_tick, 71) << "every two seconds";
    EXPECT_FALSE(game.has_left(0));
    touch_trigger(game);
    EXPECT_TRUE(game.has_left(0));
    game.wait(35 * 5);
    ASSERT_FALSE(game.has_left(0));
    game.stand_at(183, 0);
    EXPECT_EQ(game.state.message_tick, 71);
}

TEST(Door, WhoseNameNothingActivatesOpensToWhoComesNear) {
    LogicLevel level = with_door({{"targetname", "door"}});
    LogicGame game(level);
    game.stand_at(150, 0);
    EXPECT_TRUE(game.has_left(0));
}

TEST(Door, ThatWouldHaveToBeShotOpensToATouch) {
    LogicLevel level = with_door({{"health", "1"}});
    LogicGame game(level);
    game.stand_at(150, 0);
    EXPECT_FALSE(game.has_left(0));
    game.stand_at(183, 0);
    EXPECT_TRUE(game.has_left(0));
}

TEST(Door, TogglesByItsFlagAndStaysWhereItIs) {
    LogicLevel level = with_door({{"targetname", "door"}, {"spawnflags", "32"}, {"wait", "1"}});
    level.add("trigger_multiple", kVolume, {{"target", "door"}});
    LogicGame game(level);
    touch_trigger(game);
    game.wait(35 * 10);
    EXPECT_EQ(game.phase(0), Phase::AtEnd);
    EXPECT_TRUE(game.state.active_movers.empty());
    touch_trigger(game);
    EXPECT_EQ(game.phase(0), Phase::Returning);
    game.wait(10);
    touch_trigger(game);
    EXPECT_EQ(game.phase(0), Phase::Leaving) << "on its way back, too";
}

TEST(Door, ThatStartsOpenShutsWhenItIsActivated) {
    LogicLevel level = with_door({{"targetname", "door"}, {"spawnflags", "1"}, {"wait", "-1"}});
    level.add("trigger_once", kVolume, {{"target", "door"}});
    LogicGame game(level);
    EXPECT_TRUE(is_free(game.level, game.state, world_vector(208, 0, 24)));
    touch_trigger(game);
    game.wait(50);
    EXPECT_FALSE(is_free(game.level, game.state, world_vector(208, 0, 24)));
    EXPECT_EQ(offset_of(game.level.movers[0], game.state.movers[0]), Vec3<World>{});
}

TEST(Door, OfAGroupOpenTogetherHoweverTheyAreActivatedUnlessTheyAreNotLinked) {
    LogicLevel level = with_door({{"targetname", "left"}, {"wait", "-1"}});
    level.add("func_door", {200, 64, 0, 216, 192, 128}, {{"angle", "-1"}, {"wait", "-1"}});
    level.add("func_door", {200, 192, 0, 216, 300, 128}, {{"angle", "-1"}, {"spawnflags", "4"}});
    level.add("trigger_once", kVolume, {{"target", "left"}});
    LogicGame game(level);
    game.put_at(150, 0);
    game.play(35, kStand);
    EXPECT_FALSE(game.has_left(0));
    EXPECT_FALSE(game.has_left(1)) << "one's name shuts both";
    touch_trigger(game);
    EXPECT_TRUE(game.has_left(0));
    EXPECT_TRUE(game.has_left(1));
    EXPECT_FALSE(game.has_left(2));
}

TEST(Door, StaysOpenForAsLongAsItsWaitAfterTheLastTouchThatCounted) {
    LogicLevel level = with_door({{"wait", "2"}});
    LogicGame game(level);
    game.put_at(150, 0);
    game.play(350, kStand);
    EXPECT_EQ(game.phase(0), Phase::AtEnd);
    game.wait(34);
    EXPECT_EQ(game.phase(0), Phase::AtEnd) << "touched no more than a second before";
    game.wait(37);
    EXPECT_EQ(game.phase(0), Phase::Returning);
}

TEST(Door, FiresWheneverItSetsOutToOpen) {
    LogicLevel level = with_door({{"target", "light"}, {"wait", "1"}});
    level.add("light", {{"targetname", "light"}, {"style", "32"}});
    LogicGame game(level);
    game.stand_at(150, 0);
    EXPECT_NE(game.state.dark_styles, 0u);
    game.wait(42 + 35 + 20);
    ASSERT_EQ(game.phase(0), Phase::Returning);
    game.stand_at(150, 0);
    EXPECT_EQ(game.phase(0), Phase::Leaving);
    EXPECT_EQ(game.state.dark_styles, 0u);
}

TEST(Door, ThatNeverReturnsWaitsForWhoIsInItsWay) {
    LogicLevel level;
    level.add("func_door", {200, -64, 128, 264, 64, 192},
              {{"angle", "-2"}, {"lip", "-56"}, {"wait", "-1"}, {"targetname", "press"}});
    level.add("trigger_once", kVolume, {{"target", "press"}});
    LogicGame game(level);
    touch_trigger(game);
    game.put_at(232, 0);
    game.play(100, kStand);
    EXPECT_EQ(game.phase(0), Phase::Leaving);
    EXPECT_NEAR(game.travelled(0), 128 - 56, 3);
    game.wait(35);
    EXPECT_EQ(game.phase(0), Phase::AtEnd);
}

TEST(Button, FiresWhenItIsInAndComesBackAfterItsWait) {
    LogicLevel level;
    level.add("func_button", {200, -64, 0, 244, 64, 64}, {{"angle", "0"}, {"target", "light"}});  // 40 units
    level.add("light", {{"targetname", "light"}, {"style", "32"}});
    LogicGame game(level);
    game.stand_at(183, 0);
    EXPECT_EQ(game.phase(0), Phase::Leaving);
    EXPECT_FALSE(shows_other_frames(game.level.movers[0], game.state.movers[0]));
    game.wait(34);
    EXPECT_EQ(game.state.dark_styles, 0u);
    game.wait(2);
    EXPECT_NE(game.state.dark_styles, 0u);
    EXPECT_TRUE(shows_other_frames(game.level.movers[0], game.state.movers[0]));
    game.wait(34);
    EXPECT_EQ(game.phase(0), Phase::AtEnd);
    game.wait(2);
    EXPECT_EQ(game.phase(0), Phase::Returning);
    EXPECT_FALSE(shows_other_frames(game.level.movers[0], game.state.movers[0]));
    game.wait(36);
    EXPECT_EQ(game.phase(0), Phase::AtStart);
    EXPECT_EQ(game.travelled(0), 0);
}

TEST(Button, ThatWouldHaveToBeShotAnswersToTouchToo) {
    LogicLevel level;
    level.add("func_button", {200, -64, 0, 210, 64, 64}, {{"health", "1"}, {"angle", "0"}});
    LogicGame game(level);
    game.stand_at(183, 0);
    EXPECT_TRUE(game.has_left(0));
}

// A plate 136 high that goes down by 128.
TEST(Lift, WithANameWaitsAboveUntilItIsActivatedAndIsALiftLikeAnyOtherThen) {
    LogicLevel level;
    level.add("func_plat", {100, -64, 0, 228, 64, 136}, {{"height", "128"}, {"targetname", "lift"}});
    level.add("trigger_multiple", kVolume, {{"target", "lift"}});
    LogicGame game(level);
    game.stand_at(164, 0, 136);
    game.play(35 * 5, kStand);
    EXPECT_NEAR(game.feet(), 136, 0.1);
    EXPECT_TRUE(game.state.active_movers.empty());
    touch_trigger(game);
    game.wait(35);
    EXPECT_EQ(game.phase(0), Phase::AtStart);
    touch_trigger(game);
    EXPECT_EQ(game.phase(0), Phase::AtStart) << "activated once";
    game.stand_at(164, 0, 8);
    game.play(40, kStand);
    EXPECT_NEAR(game.feet(), 136, 0.1);
}

TEST(Lift, StaysAboveForThreeSecondsOrOneAfterItsRiderLeft) {
    LogicLevel level;
    level.add("func_plat", {100, -64, 0, 228, 64, 136}, {{"height", "128"}, {"speed", "1000"}});
    LogicGame game(level);
    game.stand_at(164, 0, 8);
    game.wait(6);
    ASSERT_EQ(game.phase(0), Phase::AtEnd);
    game.wait(103);
    EXPECT_EQ(game.phase(0), Phase::AtEnd);
    game.wait(2);
    EXPECT_EQ(game.phase(0), Phase::Returning);
    game.wait(10);
    game.stand_at(164, 0, 8);
    game.play(10, kStand);
    ASSERT_EQ(game.phase(0), Phase::AtEnd);
    game.wait(34);
    EXPECT_EQ(game.phase(0), Phase::AtEnd);
    game.wait(2);
    EXPECT_EQ(game.phase(0), Phase::Returning);
}

TEST(Lift, WithALowTriggerIsStartedOnlyFromBelow) {
    for (const bool is_low : {false, true}) {
        LogicLevel level;
        level.add("func_plat", {100, -64, 0, 228, 64, 136}, {{"height", "128"}, {"spawnflags", is_low ? "1" : "0"}});
        LogicGame game(level);
        game.stand_at(164, 0, 60);
        EXPECT_EQ(game.has_left(0), !is_low);
        game.stand_at(164, 0, 8);
        EXPECT_TRUE(game.has_left(0));
    }
}

// 64 wide (to the right of its arrow, which points along +x), 32 long.
LogicLevel with_secret_door(Pairs pairs) {
    LogicLevel level;
    level.add("func_door_secret", {200, -32, 0, 232, 32, 96}, std::move(pairs));
    return level;
}

TEST(SecretDoor, GoesAsideThenBackWaitsAndReturnsTheSameWay) {
    LogicLevel level = with_secret_door({{"angle", "0"}, {"wait", "2"}});
    LogicGame game(level);
    const auto offset = [&] { return offset_of(game.level.movers[0], game.state.movers[0]); };
    game.stand_at(183, 0);
    EXPECT_EQ(game.phase(0), Phase::Leaving);
    game.wait(45);  // 64 units at 50 a second: 44.8 ticks
    EXPECT_EQ(offset(), world_vector(0, -64, 0));
    game.wait(35);
    EXPECT_EQ(offset(), world_vector(0, -64, 0)) << "a second";
    game.wait(23);
    EXPECT_EQ(offset(), world_vector(32, -64, 0));
    EXPECT_EQ(game.phase(0), Phase::AtEnd);
    game.wait(70);
    EXPECT_EQ(offset(), world_vector(32, -64, 0));
    game.wait(23);
    EXPECT_EQ(offset(), world_vector(0, -64, 0));
    game.wait(35);
    EXPECT_EQ(offset(), world_vector(0, -64, 0));
    game.wait(45);
    EXPECT_EQ(offset(), Vec3<World>{});
    EXPECT_EQ(game.phase(0), Phase::AtStart);
}

TEST(SecretDoor, FlagsAndSizesSayWhither) {
    const auto ends_at = [](Pairs pairs) {
        LogicLevel level = with_secret_door(std::move(pairs));
        LogicGame game(level);
        game.stand_at(183, 0);
        game.wait(35 * 60);
        EXPECT_EQ(game.phase(0), Phase::AtEnd);
        return offset_of(game.level.movers[0], game.state.movers[0]);
    };
    EXPECT_EQ(ends_at({{"spawnflags", "1"}}), world_vector(32, -64, 0));
    EXPECT_EQ(ends_at({{"spawnflags", "3"}}), world_vector(32, 64, 0));
    EXPECT_EQ(ends_at({{"spawnflags", "5"}}), world_vector(32, 0, -96));
    EXPECT_EQ(ends_at({{"wait", "-1"}, {"t_width", "10"}, {"t_length", "20"}}), world_vector(20, -10, 0));
}

TEST(SecretDoor, WithANameOpensOnlyWhenItIsActivatedUnlessItsFlagSaysSo) {
    for (const bool answers : {false, true}) {
        LogicLevel level = with_secret_door(
            {{"targetname", "wall"}, {"spawnflags", answers ? "16" : "0"}, {"message", "A hollow wall"}});
        level.add("trigger_once", kVolume, {{"target", "wall"}});
        LogicGame game(level);
        game.stand_at(183, 0);
        EXPECT_EQ(game.has_left(0), answers);
        EXPECT_EQ(game.message(), "A hollow wall");
        touch_trigger(game);
        EXPECT_TRUE(game.has_left(0));
    }
}

}  // namespace
}  // namespace oblong
