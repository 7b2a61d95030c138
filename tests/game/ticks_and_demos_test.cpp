#include <gtest/gtest.h>

#include <cstdint>

#include "engine/base/input_error.h"
#include "game/input/tick_input_source.h"
#include "game/simulation/demo.h"
#include "game/simulation/tick.h"
#include "tests/game/logic_level.h"
#include "tests/support/refusal.h"

namespace oblong::test {
namespace {

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

ToyLevel with_things() {
    ToyLevel toy;
    toy.add_model(floor_and({{300, -500, 0, 900, 500, 16}})).add_model({{200, -64, 0, 216, 64, 128}});
    toy.add_entity({{"classname", "func_door"}, {"model", "*1"}, {"angle", "-1"}});
    return toy;
}

// Ahead with a jump now and then, a turn, ahead again.
Controls walk(int tick) {
    Controls controls;
    controls.moves.set(Action::Forward, tick % 100 < 80);
    controls.moves.set(Action::TurnRight, tick % 100 >= 80);
    controls.moves.set(Action::Jump, tick % 100 == 40);
    return controls;
}

Demo record(int ticks) {
    ToyGame game(with_things());
    TickInputSource input(game.state, {}, true);
    for (int tick = 0; tick < ticks; ++tick) {
        input.gather(walk(tick));
        input.play_tick(game.level, game.state);
    }
    return input.recorded();
}

TEST(Demo, ReplayLeadsToTheSameStateAtEveryTick) {
    const Demo demo = record(700);
    ASSERT_EQ(demo.ticks.size(), 700u);
    ToyGame game(with_things());
    TickInputSource input(game.state, demo, false);
    for (const DemoTick& tick : demo.ticks) {
        input.play_tick(game.level, game.state);
        ASSERT_EQ(hash_of(game.state), tick.state_hash);
    }
    EXPECT_FALSE(input.is_replaying());
    EXPECT_NE(demo.ticks.front().state_hash, demo.ticks.back().state_hash);
}

TEST(Demo, ADifferentGameIsNoticed) {
    Demo demo = record(50);
    ToyGame game(with_things());
    demo.ticks[30].input.yaw = 1;
    TickInputSource input(game.state, demo, false);
    for (int tick = 0; tick < 30; ++tick) input.play_tick(game.level, game.state);
    EXPECT_THROW(input.play_tick(game.level, game.state), InputError);
}

TEST(Demo, AnotherLevelIsNoticedAtOnce) {
    const Demo demo = record(5);
    ToyGame other(with_things(), 100);
    EXPECT_THROW(TickInputSource(other.state, demo, false), InputError);
}

TEST(Demo, FileComesBackAsItWas) {
    const Demo demo = record(100);
    EXPECT_EQ(decode_demo(encode_demo(demo)), demo);
    EXPECT_EQ(decode_demo(encode_demo({})), Demo{});
    EXPECT_EQ(encode_demo(demo).size(), 28u + 100 * 23);
}

TEST(Demo, TheFirstVersionHasNoViewAndNoWork) {
    Demo demo = record(3);
    demo.ticks[1].input.view = {6, 0, 2, 1, 2, 12};
    demo.ticks[2].input.work = 65'535;
    std::vector<std::uint8_t> bytes = encode_demo(demo);
    EXPECT_EQ(decode_demo(bytes), demo);
    constexpr std::ptrdiff_t kHead = 28, kBefore = 7, kView = 8, kTick = 23;
    for (std::ptrdiff_t tick = 2; tick >= 0; --tick) {
        const auto view = bytes.begin() + kHead + tick * kTick + kBefore;
        bytes.erase(view, view + kView);
    }
    bytes[8] = 1;
    for (DemoTick& tick : demo.ticks) {
        tick.input.view = kUsualView;
        tick.input.work = 0;
    }
    EXPECT_EQ(decode_demo(bytes), demo);
}

TEST(Demo, EveryTruncationIsRefused) {
    auto bytes = encode_demo(record(3));
    expect_no_prefix_is_read(bytes, [](const auto& part) { return refusal([&] { decode_demo(part); }); });
    bytes.push_back(0);
    EXPECT_THROW(decode_demo(bytes), InputError);
}

TEST(Demo, BadFieldsAreRefusedWithTheirOffset) {
    const auto bytes = encode_demo(record(3));
    const auto where = [&](int at, int value) {
        auto bad = bytes;
        item(bad, at) = static_cast<std::uint8_t>(value);
        return place_of_refusal([&] { decode_demo(bad); });
    };
    // The version, the ticks a second, a speed of -128, an unknown button, an accuracy beyond "other".
    for (const auto& [at, value] : {std::pair{0, 'X'}, {8, 3}, {12, 70}, {28, 0x80}, {34, 0x80}, {35, 7}})
        EXPECT_EQ(where(at, value), "offset " + std::to_string(at));
    EXPECT_EQ(where(27, 0xff), "offset 24");  // four thousand million ticks
}

}  // namespace
}  // namespace oblong::test
