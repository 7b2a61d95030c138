#include <gtest/gtest.h>

#include <cstdint>

#include "game/input/tick_input_source.h"
#include "game/simulation/tick.h"
#include "game/view/game_renderer.h"
#include "tests/game/toy_game.h"

namespace oblong {
namespace {

using test::floor_and;
using test::ToyGame;
using test::ToyLevel;

TEST(TickClock, GivesThirtyFiveTicksASecondHoweverItIsCut) {
    for (const std::uint64_t piece_us : {1u, 7u, 1000u, 6944u, 16'667u, 100'000u}) {
        TickClock clock;
        std::uint64_t passed_us = 0;
        std::int64_t ticks = 0;
        for (; passed_us < 2'000'000; passed_us += piece_us) ticks += clock.advance(piece_us);
        EXPECT_EQ(ticks, static_cast<std::int64_t>(passed_us * 35 / 1'000'000)) << piece_us;
    }
}

TEST(TickClock, NoTimeNegativeTimeAndALongSleep) {
    TickClock clock;
    EXPECT_EQ(clock.advance(0), 0);
    EXPECT_EQ(clock.advance(std::uint64_t{0} - 5000), 0);
    EXPECT_EQ(clock.advance(5'000'000), 8);  // a quarter of a second of it
    EXPECT_LT(clock.fraction_16(), 65'536);
}

// Plays the same hands for 100 ms of time in pieces; the state that it leads to.
GameState played(std::uint64_t piece_us, const Controls& controls) {
    ToyGame game(ToyLevel().add_model(floor_and({{60, -500, 0, 900, 500, 16}})));
    TickClock clock;
    LiveInput live;
    for (int second = 0; second < 20; ++second)
        for (std::uint64_t us = 0; us < 100'000; us += piece_us) {
            live.gather(controls);
            for (int due = clock.advance(piece_us); due > 0; --due) step(game.level, game.state, live.next());
        }
    return game.state;
}

TEST(Ticks, OnePieceOf100MsAndHundredOf1MsLeadToTheSameState) {
    Controls controls;
    controls.moves = {Action::Forward, Action::TurnLeft, Action::LookDown, Action::Jump};
    const GameState whole = played(100'000, controls);
    EXPECT_EQ(whole.tick, 70);
    EXPECT_EQ(whole, played(1000, controls));
    EXPECT_EQ(whole, played(20'000, controls));
    EXPECT_NE(whole, played(100'000, Controls{}));
}

TEST(LiveInput, MouseIsNeitherLostNorDoubled) {
    LiveInput live;
    Controls controls;
    controls.mouse_x = 100;
    controls.mouse_y = -50;
    for (int i = 0; i < 3; ++i) live.gather(controls);
    EXPECT_EQ(live.look_offset(0).yaw, -300 * 12);  // shown before the tick knows
    const TickInput input = live.next();
    EXPECT_EQ(input.yaw, -300 * 12);
    EXPECT_EQ(input.pitch, -150 * 12);
    EXPECT_EQ(live.look_offset(0).yaw, 0);
    EXPECT_EQ(live.next().yaw, 0);
}

TEST(View, StandsBetweenTwoTicks) {
    GameState before, after;
    after.player.position = Position{World::from_int(10), World::from_int(-20), World{}};
    const auto x_at = [&](std::int32_t fraction) {
        return camera_at({before, after, fraction}, {}, Degrees::from_int(90)).eye.x;
    };
    EXPECT_EQ(x_at(0), World{});
    EXPECT_EQ(x_at(32'768), World::from_int(5));
    EXPECT_EQ(x_at(65'536), World::from_int(10));
}

TEST(View, ATeleportIsNoFlight) {
    GameState before, after;
    after.player.position.x = World::from_int(1000);
    EXPECT_EQ(camera_at({before, after, 0}, {}, Degrees::from_int(90)).eye.x, World::from_int(1000));
}

}  // namespace
}  // namespace oblong
