#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "engine/base/little_endian.h"
#include "game/saves/saved_game.h"
#include "game/simulation/collision.h"
#include "game/simulation/game_level.h"
#include "tests/game/hostile_levels.h"
#include "tests/game/scenario.h"

namespace oblong::test {
namespace {

constexpr int kTicks = 14;

TickInput input_of(std::int64_t tick) {
    return {static_cast<std::int8_t>(tick % 3 * 60), 0, static_cast<std::int16_t>(tick * 100), 0, 0};
}

class Hostile : public testing::TestWithParam<HostileLevel> {};

INSTANTIATE_TEST_SUITE_P(Levels, Hostile, testing::ValuesIn(kHostileLevels),
                         [](const auto& each) { return std::string(each.param.name); });

// One operation may exceed a bound: a door that activates its group, a mover that meets the player.
constexpr std::int32_t kLargestOperation = static_cast<std::int32_t>(kMostMovers) + 2;
constexpr std::int32_t kMostTouches =
    static_cast<std::int32_t>(BoxTree::kMostFound) * (2 + TickReport::kMostTeleports + 1);

void expect_bounded(const TickReport& report, const GameState& state) {
    // What waits, what is delayed and what is new may each exceed theirs, and touches activate beyond them.
    EXPECT_LE(report.activations, TickReport::kMostWaitingActivations + TickReport::kMostDelayedActivations +
                                      TickReport::kMostNewActivations + 4 * kLargestOperation + 2 * kMostTouches);
    EXPECT_LE(report.mover_steps, TickReport::kMostMoverSteps + kLargestOperation);
    EXPECT_LE(report.touches, kMostTouches);
    EXPECT_LE(state.delayed.size(), Activations::kMost);
    EXPECT_LE(state.backlog.waiting.size(), Activations::kMost);
}

GameState saved_and_read(const GameState& state) {
    std::vector<std::uint8_t> bytes;
    append_state(bytes, state);
    LittleEndianReader reader(bytes);
    return read_state(reader);
}

// The same game goes on from saves, again and again.
TEST_P(Hostile, NoTickDoesMoreThanItsBoundsAndSavesGoOnTheSame) {
    LogicLevel source = GetParam().make();
    LogicGame game(source);
    GameState restored = game.state;
    std::set<std::string_view> left;
    for (int tick = 0; tick < kTicks; ++tick) {
        const TickReport report = step(game.level, game.state, input_of(tick));
        expect_bounded(report, game.state);
        for (const std::string_view kind : report.left()) left.insert(kind);
        step(game.level, restored, input_of(tick));
        ASSERT_EQ(restored, game.state) << "tick " << tick;
        if (tick % 3 != 1) continue;
        ASSERT_EQ(find_inconsistency(game.level, game.state), "") << "tick " << tick;
        restored = saved_and_read(restored);
        ASSERT_EQ(hash_of(restored), hash_of(game.state));
    }
    EXPECT_EQ(left.empty(), !GetParam().is_too_much) << testing::PrintToString(left);
}

constexpr Scenario kBacklogs[] = {
    {"BoxesThatAreTouchedAreCounted", R"(
        + 3x trigger_multiple -50 -50 0 50 50 64 target=none
        + trigger_multiple 500 -50 0 600 50 64 target=none
        play 1: touches = 3
    )"},
    // More movers than a tick steps, most of them under way for ever: those after them arrive too, only later.
    {"EachMoverHasItsTurn", R"(
        + path_corner targetname=p target=q origin="1000 1000 0"
        + path_corner targetname=q target=p origin="1500 1000 0"
        + 9000x func_train 1000 1000 0 1010 1010 10 target=p
        + 1000x func_door 1000 1000 0 1010 1010 10 angle=-1 targetname=d wait=-1 spawnflags=4
        + trigger_once -50 -50 0 50 50 64 target=d
        may_be_late; play 60: left_movers = 1, arrived = 1000, phase9000 = end, phase9999 = end
    )"},
    {"RemovalsThatAreTooManyForATickComeInTheNext", R"(
        + trigger_once -50 -50 0 50 50 64 killtarget=all
        + 30000x trigger_relay targetname=all
        may_be_late; play 1: activations = 24576        # TickReport::kMostNewActivations
        play 1: activations = 5424, spent = 30001
    )"},
    // A relay that activates itself for ever holds up no button.
    {"AnEndlessOneHoldsUpNothingElse", R"(
        + trigger_once -50 -50 0 50 50 64 target=loop
        + trigger_relay targetname=loop target=loop
        + trigger_relay targetname=loop target=loop delay=0.1
        + trigger_once 100 -50 0 150 50 64 target=door
        + func_door 1000 0 0 1010 100 100 angle=-1 targetname=door
        may_be_late; play 100: backlog = 1
        stand 120 0; play 2: phase0 != start
    )"},
    {"EachOfMoreTriggersInOnePlaceThanATickLooksAtIsTouched", R"(
        + 3000x trigger_once -50 -50 0 50 50 64
        may_be_late; play 20: spent = 3000
    )"},
    // Models that the player stands clear of, but meets within a tick.
    {"ModelsWithinReachAreFew", R"(
        + 200x func_wall 40 -50 0 50 50 64
        play 1: left_obstacles = 0
    )"},
    {"TooManyModelsWithinReachAreToldOf", R"(
        + 300x func_wall 40 -50 0 50 50 64
        may_be_late; play 1: left_obstacles = 1
    )"},
};
OBLONG_SCENARIOS(Backlogs, kBacklogs);

// Counters that say their number at their last count, one after the other: what waits keeps its order and loses
// nothing. Each count takes three activations, which no tick's number is a multiple of: one may end between them.
TEST(Backlog, WhatIsTooMuchForATickHappensLaterInItsOrder) {
    constexpr int kDoors = 2000, kCounts = 40;
    LogicLevel source;
    source.add("trigger_once", {-50, -50, 0, 50, 50, 64}, {{"target", "all"}});
    for (int i = 0; i < kDoors; ++i) {
        const std::string name = "count" + std::to_string(i);
        for (int n = 0; n < kCounts; ++n) source.add("trigger_relay", {{"targetname", "all"}, {"target", name}});
        source.add("trigger_relay", {{"targetname", name}});
        source.add("trigger_counter", {{"targetname", name},
                                       {"target", "done"},
                                       {"count", std::to_string(kCounts)},
                                       {"message", std::to_string(i)},
                                       {"spawnflags", "1"}});
    }
    LogicGame game(source);
    const auto is_done = [&](const Trigger& trigger) {
        return trigger.kind == TriggerKind::Counter &&
               game.state.triggers[static_cast<std::size_t>(&trigger - game.level.triggers.data())].left == 0;
    };
    std::ptrdiff_t done = 0;
    bool has_waited = false;
    for (int tick = 0; tick < 60 && done < kDoors; ++tick) {
        const TickReport report = step(game.level, game.state, kStand);
        ASSERT_FALSE(report.has_dropped_firings);
        has_waited |= report.has_left_activations;
        const std::ptrdiff_t before = done;
        done = std::count_if(game.level.triggers.begin(), game.level.triggers.end(), is_done);
        if (done > before) {
            ASSERT_EQ(game.message(), std::to_string(done - 1)) << "the last one that is done";
        }
        // None beyond the first that is not done is done.
        const auto is_counter = [&](const Trigger& trigger) { return trigger.kind == TriggerKind::Counter; };
        std::ptrdiff_t counters = 0;
        for (const Trigger& trigger : game.level.triggers)
            if (is_counter(trigger)) {
                ASSERT_EQ(is_done(trigger), counters++ < done);
            }
    }
    EXPECT_TRUE(has_waited);
    EXPECT_EQ(done, kDoors);
    EXPECT_TRUE(game.state.backlog.is_empty());
}

// Each mover that is where the player is looks at 253 to 256 others there, at four of the positions of the player.
TEST(Backlog, FewMoversAmongManyThatMeetThePlayerMoveInATick) {
    constexpr int kMost = TickReport::kMostMoverSteps / (4 * 253) + 1;
    LogicLevel source;
    for (int i = 0; i < 1000; ++i)
        source.add("func_door", {-50, -50, 0, 50, 50, 64}, {{"angle", "0"}, {"spawnflags", "4"}, {"speed", "10"}});
    LogicGame game(source);
    int moved = 0;
    for (int tick = 0; tick < 40; ++tick) {
        const std::vector<MoverState> before = game.state.movers;
        game.play(1, kStand);
        int now = 0;
        for (std::size_t i = 0; i < before.size(); ++i) now += before[i].travelled != game.state.movers[i].travelled;
        ASSERT_LE(now, kMost) << "tick " << tick;
        moved += now;
    }
    EXPECT_GT(moved, 40);
}

// Of relays that say something after a delay, all at once.
TEST(Backlog, DelayedFiringsThatAreTooManyForATickComeInTheNext) {
    constexpr int kRelays = 10'000;
    LogicLevel source;
    source.add("trigger_once", {-50, -50, 0, 50, 50, 64}, {{"target", "all"}});
    for (int i = 0; i < kRelays; ++i)
        source.add("trigger_relay", {{"targetname", "all"}, {"delay", "0.5"}, {"message", "said"}});
    LogicGame game(source);
    ASSERT_EQ(step(game.level, game.state, kStand).activations, 2 * kRelays) << "activated and delayed";
    std::vector<std::int32_t> fired;
    while (!game.state.delayed.empty() && fired.size() < 100) {
        fired.push_back(step(game.level, game.state, kStand).activations);
        if (fired.back() == 0) fired.pop_back();
    }
    EXPECT_EQ(fired, (std::vector{TickReport::kMostDelayedActivations, kRelays - TickReport::kMostDelayedActivations}));
}

// Boxes in boxes, each wider by what a player beside the one before it needs: only beside the last a place is free.
// Each has six ways out.
TEST(WayOut, IsLookedForAtTheNearestPlacesAlone) {
    const auto way_out_of = [](int models) {
        LogicLevel source;
        for (int half = 30; models > 0; --models, half += 20)
            source.add("func_wall", {-half, -half, 24 - half, half, half, 24 + half});
        LogicGame game(source);
        return find_way_out(game.level, game.state, game.state.player.position);
    };
    const int most = static_cast<int>(kMostWaysOut) / 6;
    EXPECT_TRUE(way_out_of(most).position);
    EXPECT_TRUE(way_out_of(most + 2).is_inside_model);
    EXPECT_FALSE(way_out_of(most + 2).position);
}

}  // namespace
}  // namespace oblong::test
