#include "game/simulation/state_check.h"

#include <gtest/gtest.h>

#include <functional>

#include "game/simulation/activations.h"
#include "tests/game/logic_level.h"

namespace oblong {
namespace {

using test::kAhead;
using test::LogicGame;
using test::LogicLevel;
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

TEST(Consistency, WhatTheGameCanNotGoOnFromIsFound) {
    LogicLevel level = with_everything();
    LogicGame game(level);
    game.play(20, kAhead);
    ASSERT_EQ(game.state.delayed.size(), 1u);
    const std::vector<std::function<void(GameState&)>> spoilers{
        [](GameState& state) { state.movers.pop_back(); },
        [](GameState& state) { state.movers.emplace_back(); },
        [](GameState& state) { state.walls.clear(); },
        [](GameState& state) { state.triggers.emplace_back(); },
        [](GameState& state) { state.items.clear(); },
        [](GameState& state) { state.active_movers.clear(); },
        [](GameState& state) { state.active_movers.push_back(99); },
        [](GameState& state) { state.movers[0].leg = 1; },
        [](GameState& state) { state.movers[0].travelled = World::from_int(121); },
        [](GameState& state) { state.movers[1].travelled = World::from_int(-1); },
        [](GameState& state) { state.movers[1].wait_ticks = -2; },
        [](GameState& state) { state.movers[1].phase = static_cast<Phase>(9); },
        [](GameState& state) { state.movers[1].next_touch = -1; },
        [](GameState& state) { state.walls[0] = static_cast<WallState>(7); },
        [](GameState& state) { state.items[0] = static_cast<ItemState>(7); },
        [](GameState& state) { state.triggers[0].open_until = TriggerState::kNever; },
        [](GameState& state) { state.delayed[0].by.index = 99; },
        [](GameState& state) { state.delayed[0].by.kind = EntityRef::Kind::Wall; },
        [](GameState& state) { state.delayed[0].by.kind = static_cast<EntityRef::Kind>(9); },
        [](GameState& state) { state.delayed[0].tick = state.tick; },
        [](GameState& state) {
            state.delayed.insert(state.delayed.begin(), {state.delayed[0].tick + 1, {}});
        },
        [](GameState& state) { state.delayed.resize(Activations::kMost + 1, state.delayed[0]); },
        [](GameState& state) {
            state.backlog.waiting.resize(Activations::kMost + 1, {0, 0, false});
        },
        [](GameState& state) {
            state.backlog.waiting = {{99, 0, false}};
        },
        [](GameState& state) {
            state.backlog.waiting = {{0, 99, false}};
        },
        [](GameState& state) { state.backlog.next_mover = 99; },
        [](GameState& state) { state.backlog.next_touch_box = 99; },
        [](GameState& state) { state.backlog.next_trigger_box = 99; },
        [](GameState& state) { state.backlog.next_item_box = 99; },
        [](GameState& state) { state.shown_message = 9; },
        [](GameState& state) { state.shown_message = -2; },
        [](GameState& state) { state.exit = 9; },
        [](GameState& state) { state.found_secrets = 2; },
        [](GameState& state) { state.keys = 4; },
        [](GameState& state) { state.tick = -1; },
        [](GameState& state) { state.respawn.position.x = World::lowest(); },
        [](GameState& state) { state.player.position.z = World::highest(); },
        [](GameState& state) { state.player.velocity.z = World::lowest(); },
        [](GameState& state) { state.player.pitch = 20'000; },
        [](GameState& state) { state.player.eye_lag = World::from_int(19); },
        [](GameState& state) { state.player.ground = 99; },
        [](GameState& state) { state.player.depth = static_cast<Depth>(4); },
    };
    GameState waits = game.state;
    waits.backlog.waiting = {{0, 0, false}};
    ASSERT_TRUE(is_consistent(game.level, waits));
    ASSERT_TRUE(is_consistent(game.level, game.state));
    for (std::size_t i = 0; i < spoilers.size(); ++i) {
        GameState spoilt = game.state;
        spoilers[i](spoilt);
        EXPECT_FALSE(is_consistent(game.level, spoilt)) << "spoiler " << i;
    }
}

TEST(Consistency, SaysWhatIsWrong) {
    LogicLevel level = with_everything();
    LogicGame game(level);
    game.state.movers.pop_back();
    EXPECT_EQ(find_inconsistency(game.level, game.state), "movers: 2, expected 3");
}

}  // namespace
}  // namespace oblong
