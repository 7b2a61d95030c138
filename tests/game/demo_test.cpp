#include "game/simulation/demo.h"

#include <gtest/gtest.h>

#include "engine/base/input_error.h"
#include "game/input/tick_input_source.h"
#include "tests/game/toy_game.h"
#include "tests/support/refusal.h"

namespace oblong {
namespace {

using test::floor_and;
using test::ToyGame;
using test::ToyLevel;

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
    EXPECT_EQ(encode_demo(demo).size(), 28u + 100 * 15);
}

TEST(Demo, EveryTruncationIsRefused) {
    const auto bytes = encode_demo(record(3));
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THROW(decode_demo(std::span(bytes).first(size)), InputError) << size;
    auto longer = bytes;
    longer.push_back(0);
    EXPECT_THROW(decode_demo(longer), InputError);
}

TEST(Demo, BadFieldsAreRefusedWithTheirOffset) {
    const auto bytes = encode_demo(record(3));
    const auto where = [&](std::size_t at, std::uint8_t value) {
        auto bad = bytes;
        bad[at] = value;
        return test::place_of_refusal([&] { decode_demo(bad); });
    };
    EXPECT_EQ(where(0, 'X'), "offset 0");
    EXPECT_EQ(where(8, 2), "offset 8");       // version
    EXPECT_EQ(where(12, 70), "offset 12");    // ticks a second
    EXPECT_EQ(where(27, 0xff), "offset 24");  // four thousand million ticks
    EXPECT_EQ(where(28, 0x80), "offset 28");  // a speed of -128
    EXPECT_EQ(where(34, 0x80), "offset 34");  // an unknown button
}

}  // namespace
}  // namespace oblong
