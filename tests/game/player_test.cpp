#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/simulation/slide_move.h"
#include "tests/game/toy_game.h"

namespace oblong {
namespace {

using test::floor_and;
using test::kAhead;
using test::kJump;
using test::kStand;
using test::Solid;
using test::ToyGame;
using test::ToyLevel;

ToyLevel room(std::vector<Solid> others = {}) {
    return ToyLevel().add_model(floor_and(std::move(others)));
}

TEST(Player, StandsStill) {
    ToyGame game(room());
    game.play(35, kStand);
    EXPECT_EQ(game.x(), 0);
    EXPECT_EQ(game.state.player.velocity, Velocity{});
    EXPECT_NEAR(game.feet(), 1.0 / 32, 0.001);  // the trace keeps 1/32 unit of air
}

TEST(Player, FallsAsGravityHasIt) {
    ToyGame game(room(), 1000);
    game.play(35, kStand);  // v = 800 t; s = sum of v / 35 over 35 ticks = 400 * 36 / 35
    EXPECT_NEAR(game.feet(), 1001 - 400.0 * 36 / 35, 0.1);
    EXPECT_NEAR(game.state.player.velocity.z.raw / 4096.0, -800, 0.1);
}

TEST(Player, ReachesTopSpeedAndNoMore) {
    ToyGame game(room());
    game.play(35, kAhead);
    EXPECT_NEAR(game.speed(), 320, 0.5);
    const double before = game.x();
    game.play(35, kAhead);
    EXPECT_NEAR(game.x() - before, 320, 0.5);
}

TEST(Player, IsNoFasterAskew) {
    ToyGame game(room());
    game.play(35, {127, 127, 0, 0, 0});
    EXPECT_NEAR(length_of(game.state.player.velocity).raw / 4096.0, 320, 0.5);
}

TEST(Player, FrictionStops) {
    ToyGame game(room());
    game.play(35, kAhead);
    game.play(35, kStand);
    EXPECT_EQ(game.state.player.velocity, Velocity{});
}

TEST(Player, StopsAtAWall) {
    ToyGame game(room({{200, -500, 0, 220, 500, 300}}));
    game.play(70, kAhead);
    EXPECT_NEAR(game.x(), 200 - 16, 0.1);
}

TEST(Player, SlidesAlongAWall) {
    ToyGame game(room({{200, -5000, 0, 220, 5000, 300}}));
    game.play(105, {127, 127, 0, 0, 0});
    EXPECT_NEAR(game.x(), 184, 0.1);
    EXPECT_LT(game.y(), -300);
}

TEST(Player, StaysInACorner) {
    ToyGame game(room({{200, -500, 0, 220, 500, 300}, {-500, -100, 0, 500, -80, 300}}));
    game.play(105, {127, 127, 0, 0, 0});
    EXPECT_NEAR(game.x(), 184, 0.2);
    EXPECT_NEAR(game.y(), -64, 0.2);
}

TEST(Player, ClimbsAStepOf18ButNotOf19) {
    ToyGame low(room({{100, -500, 0, 900, 500, 18}})), high(room({{100, -500, 0, 900, 500, 19}}));
    low.play(35, kAhead);
    high.play(35, kAhead);
    EXPECT_GT(low.x(), 150);
    EXPECT_NEAR(low.feet(), 18, 0.1);
    EXPECT_NEAR(high.x(), 84, 0.1);
}

std::vector<Solid> stairs() {
    std::vector<Solid> steps;
    for (std::int32_t i = 0; i < 16; ++i) steps.push_back({100 + 24 * i, -500, 0, 1400, 500, 16 * (i + 1)});
    return steps;
}

TEST(Player, ClimbsStairsAndComesDownThemWithoutFlying) {
    ToyGame game(room(stairs()));
    game.play(90, kAhead);
    EXPECT_NEAR(game.feet(), 256, 0.1);
    const TickInput back{-127, 0, 0, 0, 0};
    for (int i = 0; i < 90; ++i) {
        step(game.level, game.state, back);
        EXPECT_NE(game.state.player.ground, Player::kNoGround) << "tick " << i;
    }
    EXPECT_NEAR(game.feet(), 0, 0.1);
}

TEST(Player, EyeGlidesUpAStep) {
    ToyGame game(room({{100, -500, 0, 900, 500, 16}}));
    World last{};
    for (int i = 0; i < 35; ++i) {
        step(game.level, game.state, kAhead);
        const World eye = game.state.player.position.z - game.state.player.eye_lag;
        if (i > 0) {
            EXPECT_LE((eye - last).raw, World::from_int(5).raw);
        }
        last = eye;
    }
    EXPECT_EQ(game.state.player.eye_lag, World{});
}

TEST(Player, JumpsAsHighAsItsSpeedAllowsAndOnceAPress) {
    ToyGame game(room());
    game.play(2, kStand);
    double highest = 0;
    for (int i = 0; i < 60; ++i) {
        step(game.level, game.state, kJump);
        highest = std::max(highest, game.feet());
    }
    EXPECT_NEAR(highest, 270.0 * 270 / 1600, 4.5);  // v^2 / 2g; ticks are coarse
    EXPECT_NEAR(game.feet(), 0, 0.1);               // the key is still held
}

TEST(Player, JumpsOverAGapThatWalkingFallsInto) {
    const std::vector<Solid> gap{
        {-500, -500, -200, 100, 500, 0}, {230, -500, -200, 900, 500, 0}, {-900, -900, -300, 900, 900, -200}};
    ToyGame walker(ToyLevel().add_model(gap)), jumper(ToyLevel().add_model(gap));
    walker.play(70, kAhead);
    EXPECT_LT(walker.feet(), -150);
    while (jumper.x() < 95) jumper.play(1, kAhead);
    jumper.play(1, {127, 0, 0, 0, kJumpButton});
    jumper.play(30, kAhead);
    EXPECT_NEAR(jumper.feet(), 0, 1);
    EXPECT_GT(jumper.x(), 240);
}

TEST(Player, SinksSwimsAndIsSlowerInWater) {
    ToyGame game(ToyLevel(400).add_model(floor_and({})), 200);
    game.play(35, kStand);
    EXPECT_EQ(game.state.player.depth, Depth::Eyes);
    EXPECT_NEAR(game.state.player.velocity.z.raw / 4096.0, -60 * 0.7, 8);
    game.play(70, kAhead);
    EXPECT_LT(game.speed(), 230);
    const double before = game.feet();
    game.play(35, kJump);
    EXPECT_GT(game.feet(), before + 50);
}

TEST(Player, StartInTheFloorIsLiftedOut) {
    ToyGame game(room(), -10);
    game.play(5, kStand);
    EXPECT_NEAR(game.feet(), 0, 0.1);
}

TEST(Player, FallingOutOfTheWorldBeginsAnew) {
    ToyGame game(ToyLevel().add_model({{5000, 5000, 0, 5001, 5001, 1}}));
    game.play(35 * 25, kStand);  // 2,000 units a second at the most
    EXPECT_GT(game.feet(), -40'001);
    EXPECT_LT(game.state.player.velocity.z, World{});
}

TEST(Player, HostileInputsStayInTheRoom) {
    ToyGame game(room({{200, -2000, 0, 220, 2000, 900},
                       {-220, -2000, 0, -200, 2000, 900},
                       {-2000, 200, 0, 2000, 220, 900},
                       {-2000, -220, 0, 2000, -200, 900},
                       {-2000, -2000, 200, 2000, 2000, 220}}));
    std::uint32_t seed = 1;
    for (int i = 0; i < 20'000; ++i) {
        seed = seed * 1'664'525 + 1'013'904'223;
        const auto any = [&](int shift) { return static_cast<std::int8_t>(seed >> shift); };
        step(game.level, game.state,
             {any(3), any(9), static_cast<std::int16_t>(any(13) * 256), static_cast<std::int16_t>(seed >> 16),
              static_cast<std::uint8_t>(seed >> 31)});
        ASSERT_LE(std::abs(game.x()), 184) << "tick " << i;
        ASSERT_LE(std::abs(game.y()), 184) << "tick " << i;
        ASSERT_GE(game.feet(), 0) << "tick " << i;
    }
}

}  // namespace
}  // namespace oblong
