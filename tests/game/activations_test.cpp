#include <gtest/gtest.h>

#include "game/simulation/collision.h"
#include "tests/game/logic_level.h"

namespace oblong {
namespace {

using test::kStand;
using test::LogicGame;
using test::LogicLevel;
using test::Pairs;
using Phase = MoverState::Phase;

// Where the player sets off a trigger, and far from it a door that only others open.
LogicLevel with_trigger(const Pairs& trigger, const char* its_class = "trigger_once") {
    LogicLevel level;
    level.add(its_class, {100, -50, 0, 150, 50, 64}, trigger);
    level.add("func_door", {1000, 0, 0, 1010, 100, 100}, {{"angle", "-1"}, {"targetname", "door"}, {"wait", "-1"}});
    return level;
}

TEST(Activation, ATargetIsActivatedAndAMessageShown) {
    LogicLevel level = with_trigger({{"target", "door"}, {"message", "It moves"}});
    LogicGame game(level);
    game.play(35, kStand);
    EXPECT_FALSE(game.has_left(0));
    EXPECT_EQ(game.message(), "");
    game.stand_at(120, 0);
    EXPECT_TRUE(game.has_left(0));
    EXPECT_EQ(game.message(), "It moves");
    EXPECT_EQ(game.state.message_tick, 36);
}

TEST(Activation, ADelayIsInSecondsAndHoldsTheMessageToo) {
    LogicLevel level = with_trigger({{"target", "door"}, {"message", "It moves"}, {"delay", "2"}});
    LogicGame game(level);
    game.stand_at(120, 0);
    game.wait(69);
    EXPECT_FALSE(game.has_left(0));
    EXPECT_EQ(game.message(), "");
    game.wait(1);
    EXPECT_TRUE(game.has_left(0));
    EXPECT_EQ(game.message(), "It moves");
    EXPECT_TRUE(game.state.delayed.empty());
}

TEST(Activation, WhatWasRemovedIsNeitherSolidNorActivatedNorTouched) {
    LogicLevel level = with_trigger({{"killtarget", "gone"}, {"target", "door"}});
    level.add("func_wall", {300, -50, 0, 310, 50, 100}, {{"targetname", "gone"}});
    level.add("func_door", {500, -50, 0, 510, 50, 100}, {{"targetname", "gone"}, {"angle", "-1"}});
    level.add("trigger_once", {700, -50, 0, 750, 50, 64}, {{"targetname", "gone"}, {"target", "door"}});
    level.add("item_key1", {{"origin", "900 0 24"}, {"targetname", "gone"}});
    LogicGame game(level);
    const Position in_wall = world_vector(305, 0, 24), in_door = world_vector(505, 0, 24);
    EXPECT_FALSE(is_free(game.level, game.state, in_wall));
    EXPECT_FALSE(is_free(game.level, game.state, in_door));
    game.stand_at(120, 0);
    EXPECT_FALSE(game.has_left(0)) << "as in Quake, what removes something activates nothing";
    EXPECT_TRUE(is_free(game.level, game.state, in_wall));
    EXPECT_TRUE(is_free(game.level, game.state, in_door));
    game.stand_at(720, 0);
    EXPECT_FALSE(game.has_left(0));
    game.stand_at(900, 0);
    EXPECT_EQ(game.state.keys, 0);
    EXPECT_EQ(game.state.items.at(0), ItemState::Removed);
}

TEST(Activation, AWallShowsItsOtherFramesByTurns) {
    LogicLevel level = with_trigger({{"target", "wall"}, {"wait", "1"}}, "trigger_multiple");
    level.add("func_wall", {300, -50, 0, 310, 50, 100}, {{"targetname", "wall"}});
    LogicGame game(level);
    game.stand_at(120, 0);
    EXPECT_EQ(game.state.walls.at(0), WallState::ShowsOtherFrames);
    game.put_at(120, 0);
    game.play(34, kStand);
    EXPECT_EQ(game.state.walls.at(0), WallState::ShowsOtherFrames);
    game.play(1, kStand);
    EXPECT_EQ(game.state.walls.at(0), WallState::There);
}

// A door that three buttons open, as at the start of many a level.
TEST(Counter, ADoorOfThreeButtonsOpensToTheThirdAndToNothingElse) {
    LogicLevel level;
    level.add("func_door", {1000, 0, 0, 1010, 100, 100}, {{"angle", "-1"}, {"targetname", "door"}, {"wait", "-1"}});
    level.add("trigger_counter", {{"targetname", "count"}, {"target", "door"}, {"count", "3"}});
    for (const int y : {-300, 0, 300})
        level.add("func_button", {400, y, 0, 410, y + 40, 64}, {{"target", "count"}, {"wait", "-1"}, {"angle", "0"}});
    LogicGame game(level);
    game.stand_at(980, 50);
    game.play(70, kStand);
    EXPECT_FALSE(game.has_left(0)) << "opened to whoever walks up";
    const auto press = [&](int y) {
        game.put_at(383, y + 20);
        game.play(10, kStand);  // 6 units at 40 a second
    };
    press(-300);
    EXPECT_EQ(game.message(), "Only 2 more to go");
    press(-300);
    EXPECT_EQ(game.message(), "Only 2 more to go") << "a button that stays pressed counts once";
    press(300);
    EXPECT_EQ(game.message(), "Only 1 more to go");
    EXPECT_FALSE(game.has_left(0));
    press(0);
    EXPECT_EQ(game.message(), "Sequence complete");
    EXPECT_TRUE(game.has_left(0));
}

TEST(Counter, CountsToTwoUnlessItSaysOtherwiseAndIsQuietByItsFlag) {
    LogicLevel level = with_trigger({{"target", "count"}, {"wait", "0.2"}}, "trigger_multiple");
    level.add("trigger_counter", {{"targetname", "count"}, {"target", "door"}, {"spawnflags", "1"}});
    LogicGame game(level);
    game.stand_at(120, 0);
    EXPECT_FALSE(game.has_left(0));
    game.put_at(120, 0);
    game.play(7, kStand);
    EXPECT_TRUE(game.has_left(0));
    EXPECT_EQ(game.message(), "");
}

TEST(Counter, FromFourOnTheNumberIsNotSaid) {
    LogicLevel level = with_trigger({{"target", "count"}});
    level.add("trigger_counter", {{"targetname", "count"}, {"target", "door"}, {"count", "9"}});
    LogicGame game(level);
    game.stand_at(120, 0);
    EXPECT_EQ(game.message(), "There are more to go");
}

TEST(Relay, PassesOnWithDelayMessageAndRemoval) {
    LogicLevel level = with_trigger({{"target", "relay"}});
    level.add("trigger_relay", {{"targetname", "relay"}, {"target", "door"}, {"delay", "1"}, {"message", "Now"}});
    level.add("trigger_relay", {{"targetname", "relay"}, {"killtarget", "wall"}});
    level.add("func_wall", {300, -50, 0, 310, 50, 100}, {{"targetname", "wall"}});
    LogicGame game(level);
    game.stand_at(120, 0);
    EXPECT_EQ(game.state.walls.at(0), WallState::Removed);
    EXPECT_EQ(game.message(), "");
    game.wait(35);
    EXPECT_EQ(game.message(), "Now");
    EXPECT_TRUE(game.has_left(0));
}

// Entities that activate each other for ever, and many of them.
TEST(Activation, ARingOfRelaysComesToAnEnd) {
    LogicLevel level = with_trigger({{"target", "a"}});
    for (int i = 0; i < 300; ++i) {
        level.add("trigger_relay", {{"targetname", "a"}, {"target", "b"}});
        level.add("trigger_relay", {{"targetname", "b"}, {"target", "a"}});
    }
    level.add("trigger_relay", {{"targetname", "a"}, {"target", "a"}, {"delay", "0.02"}});
    LogicGame game(level);
    game.stand_at(120, 0);
    game.wait(10);
    EXPECT_EQ(game.state.tick, 11);
    EXPECT_LE(game.state.delayed.size(), std::size_t{Activations::kMost});
}

TEST(Activation, ALongChainOfRelaysIsFollowedToItsEnd) {
    LogicLevel level = with_trigger({{"target", "0"}});
    constexpr int kLinks = 20'000;
    for (int i = 0; i < kLinks; ++i)
        level.add("trigger_relay",
                  {{"targetname", std::to_string(i)}, {"target", i + 1 < kLinks ? std::to_string(i + 1) : "door"}});
    LogicGame game(level);
    game.stand_at(120, 0);
    EXPECT_TRUE(game.has_left(0));
}

TEST(LeftOut, WhatIsNotInTheLevelAtNormalSkillIsNotThere) {
    LogicLevel level = with_trigger({{"target", "door"}, {"spawnflags", "512"}});
    level.add("func_wall", {300, -50, 0, 310, 50, 100}, {{"spawnflags", "1792"}});  // for deathmatch
    level.add("func_wall", {400, -50, 0, 410, 50, 100}, {{"spawnflags", "1280"}});  // neither easy nor hard
    level.add("func_wall", {500, -50, 0, 510, 50, 100}, {{"spawnflags", "2048"}});  // not for deathmatch
    LogicGame game(level);
    EXPECT_TRUE(game.level.triggers.empty());
    EXPECT_TRUE(is_free(game.level, game.state, world_vector(305, 0, 24)));
    EXPECT_FALSE(is_free(game.level, game.state, world_vector(405, 0, 24)));
    EXPECT_FALSE(is_free(game.level, game.state, world_vector(505, 0, 24)));
    EXPECT_EQ(game.level.walls.size(), 2u);
}

TEST(Monster, WhatItsDeathWouldOpenOpensWhenThePlayerComesToWhereItStands) {
    LogicLevel level = with_trigger({});
    level.add("monster_knight", {{"origin", "600 0 24"}, {"target", "door"}, {"targetname", "knight"}});
    level.add("monster_knight", {{"origin", "0 0 24"}, {"targetname", "door"}});
    LogicGame game(level);
    game.stand_at(120, 0);
    EXPECT_FALSE(game.has_left(0));
    game.stand_at(600 - 32 - 32 - 17, 0);
    EXPECT_FALSE(game.has_left(0));
    game.stand_at(600 - 32 - 32 - 16, 0);
    EXPECT_TRUE(game.has_left(0));
}

TEST(Monster, OneThatWaitsInATeleporterStandsAtItsExit) {
    LogicLevel level = with_trigger({});
    level.add("monster_ogre", {{"origin", "-1500 0 24"}, {"target", "door"}});
    level.add("trigger_teleport", {-1550, -50, 0, -1450, 50, 64}, {{"targetname", "come"}, {"target", "exit"}});
    level.add("info_teleport_destination", {{"origin", "600 0 0"}, {"targetname", "exit"}});
    LogicGame game(level);
    game.stand_at(-1500, 0);
    EXPECT_FALSE(game.has_left(0));
    game.stand_at(600, 0);
    EXPECT_TRUE(game.has_left(0));
}

TEST(Monster, SoDoesWhatTakingAWeaponWould) {
    LogicLevel level = with_trigger({});
    level.add("weapon_nailgun", {{"origin", "600 0 24"}, {"target", "door"}});
    LogicGame game(level);
    game.stand_at(600, 0);
    EXPECT_TRUE(game.has_left(0));
}

// Three strokes of lightning, each with both electrodes at the far end of their way.
TEST(Lightning, KillsChthonWithTheThirdStroke) {
    LogicLevel level = with_trigger({{"target", "bolt"}, {"wait", "1"}}, "trigger_multiple");
    level.add("event_lightning", {{"targetname", "bolt"}});
    level.add("monster_boss", {{"origin", "600 0 24"}, {"target", "door"}});
    for (const int y : {-600, 600})
        level.add("func_door", {0, y, 0, 40, y + 40, 108},
                  {{"angle", "-1"}, {"wait", "-1"}, {"target", "lightning"}, {"targetname", "electrodes"}});
    level.add("trigger_once", {100, 1000, 0, 150, 1050, 64}, {{"target", "electrodes"}});
    LogicGame game(level);
    game.stand_at(600, 0);
    game.put_at(120, 0);
    game.play(35 * 4, kStand);
    EXPECT_FALSE(game.has_left(0)) << "the electrodes are not in place";
    game.stand_at(120, 1020);
    game.wait(35 + 1);
    const auto strike = [&] {
        game.stand_at(120, 0);
        game.wait(35);
    };
    strike();
    strike();
    EXPECT_FALSE(game.has_left(0));
    strike();
    EXPECT_TRUE(game.has_left(0));
}

}  // namespace
}  // namespace oblong
