#include <gtest/gtest.h>

#include <functional>

#include "game/simulation/activations.h"
#include "game/simulation/game_level.h"
#include "tests/game/logic_level.h"

namespace oblong::test {
namespace {

using Phase = MoverState::Phase;

LogicLevel with_everything() {
    LogicLevel level;
    level.add("func_door", {200, -64, 0, 216, 64, 128}, {{"angle", "-1"}});
    level.add("func_door_secret", {-300, -64, 0, -216, 64, 128});
    level.add("func_train", {0, 0, 300, 50, 50, 316}, {{"target", "a"}});
    level.add("path_corner", {{"targetname", "a"}, {"target", "b"}, {"origin", "300 0 300"}});
    level.add("path_corner", {{"targetname", "b"}, {"target", "a"}, {"origin", "700 0 300"}});
    level.add("func_wall", {500, -50, 0, 510, 50, 100}, {{"targetname", "wall"}});
    level.add("trigger_once", {20, -50, 0, 30, 50, 64}, {{"target", "wall"}, {"delay", "9"}, {"message", "Soon"}});
    level.add("trigger_secret", {60, -50, 0, 70, 50, 64});
    level.add("item_key1", {{"origin", "120 0 24"}});
    return level;
}

TEST(Consistency, EveryStateOfAGameIsConsistent) {
    LogicLevel level = with_everything();
    LogicGame game(level);
    for (int tick = 0; tick < 300; ++tick) {
        game.play(1, {static_cast<std::int8_t>(tick % 90 < 60 ? 127 : -127), 0, 0, 0, 0});
        ASSERT_EQ(find_inconsistency(game.level, game.state), "") << "tick " << tick;
    }
    EXPECT_FALSE(game.state.delayed.empty());
    EXPECT_GE(game.state.active_movers.size(), 1u);
}

// What would have fired after the end waits for ever.
TEST(Consistency, AGameThatHasEndedIsConsistent) {
    LogicLevel level;
    level.add("trigger_once", {20, -50, 0, 30, 50, 64}, {{"message", "Soon"}, {"delay", "1"}});
    level.add("trigger_changelevel", {40, -50, 0, 50, 50, 64}, {{"map", "e1m2"}});
    LogicGame game(level);
    game.play(200, kAhead);
    ASSERT_TRUE(game.state.has_ended);
    EXPECT_FALSE(game.state.delayed.empty());
    EXPECT_EQ(find_inconsistency(game.level, game.state), "");
}

/// What the game cannot go on from, by a change of a state of with_everything().
struct Spoiler {
    const char* what;
    std::function<void(GameState&)> spoil;
};
const std::vector<Spoiler> kSpoilers{
    {"a mover too few", [](GameState& state) { state.movers.pop_back(); }},
    {"a mover too many", [](GameState& state) { state.movers.emplace_back(); }},
    {"no walls", [](GameState& state) { state.walls.clear(); }},
    {"a trigger too many", [](GameState& state) { state.triggers.emplace_back(); }},
    {"no items", [](GameState& state) { state.items.clear(); }},
    {"an active mover that is not listed", [](GameState& state) { state.active_movers.clear(); }},
    {"an active mover that is none", [](GameState& state) { state.active_movers.push_back(99); }},
    {"a leg that a door does not have", [](GameState& state) { state.movers[0].leg = 1; }},
    {"beyond the end of its path", [](GameState& state) { state.movers[0].travelled = World::from_int(121); }},
    {"before the start of its path", [](GameState& state) { state.movers[1].travelled = World::from_int(-1); }},
    {"a wait below none for ever", [](GameState& state) { state.movers[1].wait_ticks = -2; }},
    {"no phase", [](GameState& state) { state.movers[1].phase = static_cast<Phase>(9); }},
    {"touched before the start of time", [](GameState& state) { state.movers[1].next_touch = -1; }},
    {"no state of a wall", [](GameState& state) { state.walls[0] = static_cast<WallState>(7); }},
    {"no state of an item", [](GameState& state) { state.items[0] = static_cast<ItemState>(7); }},
    {"an item taken in no order", [](GameState& state) { state.progress.taken.clear(); }},
    {"in the order, but there", [](GameState& state) { state.items[0] = ItemState::There; }},
    {"taken twice", [](GameState& state) { state.progress.taken.push_back(0); }},
    {"taken, but no item", [](GameState& state) { state.progress.taken.push_back(99); }},
    {"open for ever", [](GameState& state) { state.triggers[0].open_until = TriggerState::kNever; }},
    {"delayed by none", [](GameState& state) { state.delayed[0].by.index = 99; }},
    {"delayed by a wall", [](GameState& state) { state.delayed[0].by.kind = EntityRef::Kind::Wall; }},
    {"delayed by no kind", [](GameState& state) { state.delayed[0].by.kind = static_cast<EntityRef::Kind>(9); }},
    {"delayed until now", [](GameState& state) { state.delayed[0].tick = state.tick; }},
    {"delays out of order",
     [](GameState& state) { state.delayed.emplace(state.delayed.begin(), state.delayed[0].tick + 1, EntityRef()); }},
    {"a message that is none", [](GameState& state) { state.message.shown = 9; }},
    {"less than no message", [](GameState& state) { state.message.shown = -2; }},
    {"an exit that is none", [](GameState& state) { state.exit = 9; }},
    {"more secrets than there are", [](GameState& state) { state.progress.found_secrets = 2; }},
    {"keys that do not exist", [](GameState& state) { state.progress.keys = 4; }},
    {"before the start", [](GameState& state) { state.tick = -1; }},
    {"a respawn outside the world", [](GameState& state) { state.progress.respawn.position.x = World::lowest(); }},
    {"a player outside the world", [](GameState& state) { state.player.position.z = World::highest(); }},
    {"too fast", [](GameState& state) { state.player.velocity.z = World::lowest(); }},
    {"a look beyond straight up", [](GameState& state) { state.player.pitch = 20'000; }},
    {"an eye too far behind", [](GameState& state) { state.player.eye_lag = World::from_int(19); }},
    {"ground that is none", [](GameState& state) { state.player.ground = 99; }},
    {"no depth", [](GameState& state) { state.player.depth = static_cast<Depth>(4); }},
    {"a lift beyond the end of its path",
     [](GameState& state) { state.movers[1].travelled = World::from_int(30'000); }},
    {"a wait of years", [](GameState& state) { state.movers[1].wait_ticks = 1 << 30; }},
    {"a mover that is active twice", [](GameState& state) { state.active_movers.assign(2, 0); }},
    {"active movers out of order",
     [](GameState& state) {
         state.active_movers.assign({1, 0});
     }},
    {"a wall too many", [](GameState& state) { state.walls.emplace_back(); }},
    {"an item too many", [](GameState& state) { state.items.emplace_back(); }},
    {"a message of later", [](GameState& state) { state.message.tick = state.tick + 1; }},
    {"just above the world", [](GameState& state) { state.player.position.z = World::from_int(40'001); }},
    {"more delayed than there may be",
     [](GameState& state) { state.delayed.resize(Activations::kMost + 1, state.delayed[0]); }},
    {"more waiting than there may be", [](GameState& state) { state.backlog.waiting.resize(Activations::kMost + 1); }},
    {"waiting by none",
     [](GameState& state) {
         state.backlog.waiting.assign(1, {99, 0, false});
     }},
    {"waiting for no target",
     [](GameState& state) {
         state.backlog.waiting.assign(1, {0, 99, false});
     }},
    {"a next mover that is none", [](GameState& state) { state.backlog.next_mover = 99; }},
    {"a next touch box that is none", [](GameState& state) { state.backlog.next_touch_box = 99; }},
    {"a next trigger box that is none", [](GameState& state) { state.backlog.next_trigger_box = 99; }},
    {"a next item box that is none", [](GameState& state) { state.backlog.next_item_box = 99; }},
};

TEST(Consistency, WhatTheGameCanNotGoOnFromIsFound) {
    LogicLevel level = with_everything();
    LogicGame game(level);
    game.play(20, kAhead);
    ASSERT_EQ(game.state.delayed.size(), 1u);
    ASSERT_EQ(game.state.progress.taken.size(), 1u);
    GameState waits = game.state;
    waits.backlog.waiting = {{0, 0, false}};
    ASSERT_EQ(find_inconsistency(game.level, waits), "");
    ASSERT_EQ(find_inconsistency(game.level, game.state), "");
    for (const auto& [what, spoil] : kSpoilers) {
        GameState spoilt = game.state;
        spoil(spoilt);
        EXPECT_NE(find_inconsistency(game.level, spoilt), "") << what;
    }
}

TEST(Consistency, SaysWhatIsWrong) {
    LogicLevel level = with_everything();
    LogicGame game(level);
    game.state.movers.pop_back();
    EXPECT_EQ(find_inconsistency(game.level, game.state), "movers: 2, expected 3");
}

}  // namespace
}  // namespace oblong::test
