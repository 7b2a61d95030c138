#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "tests/game/logic_level.h"
#include "tests/game/scenario.h"

namespace oblong::test {
namespace {

ToyLevel room(std::vector<Solid> others = {}) {
    return ToyLevel().add_model(floor_and(std::move(others)));
}

constexpr Scenario kPlayers[] = {
    {"StandsStill", R"(
        play 35: x = 0, vx = 0, vy = 0, vz = 0, feet = 0.03125 +- 0.001     # the trace keeps 1/32 unit of air
    )"},
    {"FallsAsGravityHasIt", R"(
        at 0 0 1001
        play 35: feet = 589.57 +- 0.1, vz = -800 +- 0.1     # 1001 - 400 * 36 / 35: v = 800 t in 35 steps
    )"},
    {"ReachesTopSpeedAndNoMore", R"(
        play 35 ahead: vx = 320 +- 0.5
        each 35 ahead: vx = 320 +- 0.5
    )"},
    {"IsNoFasterAskew", R"(
        play 35 askew: speed = 320 +- 0.5
    )"},
    {"IsStoppedByFriction", R"(
        play 35 ahead; play 35: vx = 0, vy = 0, vz = 0
    )"},
    {"StopsAtAWall", R"(
        + solid 200 -500 0 220 500 300
        play 70 ahead: x = 184 +- 0.1
    )"},
    {"SlidesAlongAWall", R"(
        + solid 200 -5000 0 220 5000 300
        play 105 askew: x = 184 +- 0.1, y < -300
    )"},
    {"StaysInACorner", R"(
        + solid 200 -500 0 220 500 300
        + solid -500 -100 0 500 -80 300
        play 105 askew: x = 184 +- 0.2, y = -64 +- 0.2
    )"},
    {"ClimbsALadderAsRubicon2HasIt", R"(
        + solid 100 -500 0 300 500 200
        + trigger_ladder 84 -32 0 100 32 200
        at 83 0; play 35 jump: feet = 160 +- 5
        play 35: feet = 160 +- 5, vz = 0
        play 30 leap: x > 84, feet = 200 +- 0.1, flies = 0
        play 35 ahead: x > 200
    )"},
    {"ClimbsALadderTheWayOfItsLook", R"(
        + solid 100 -500 0 300 500 200
        + trigger_ladder 84 -32 0 100 32 200
        at 83 0; play 35 ahead: feet < 1
        look 0 -20; play 35 ahead: feet = 109.4 +- 5    # 320 sin 20
        look 0 20; play 17 ahead: feet = 56.3 +- 5
        play 35 ahead: feet < 1
    )"},
    {"ClimbsNoLadderThatIsElsewhere", R"(
        + solid 100 -500 0 300 500 200
        + trigger_ladder 84 -32 0 100 32 200 angle=180
        + trigger_ladder 84 100 0 100 164 200 targetname=rope
        + trigger_once 84 100 100 100 164 120 killtarget=rope
        at 83 0; play 35 jump: feet < 60
        at 83 132; each 10 jump: feet < 80
        play 35 jump: feet < 80                         # taken away when the head was at 100
    )"},
    {"ClimbsAStepOf18", R"(
        + solid 100 -500 0 900 500 18
        play 35 ahead: x > 150, feet = 18 +- 0.1
    )"},
    {"ClimbsNoStepOf19", R"(
        + solid 100 -500 0 900 500 19
        play 35 ahead: x = 84 +- 0.1
    )"},
    {"ClimbsStairsAndComesDownThemWithoutFlying", R"(
        + 16x solid {100+24i} -500 0 1400 500 {16+16i}
        play 90 ahead: feet = 256 +- 0.1
        each 90 back: flies = 0
        : feet = 0 +- 0.1
    )"},
    {"IsLiftedOutOfAFloorThatItStartsIn", R"(
        + info_player_start origin="0 0 14"
        : feet = -9
        play 5: feet = 0 +- 0.1
    )"},
    {"FallsIntoAGap", R"(
        + no_floor
        + solid -500 -500 -200 100 500 0
        + solid 230 -500 -200 900 500 0
        + solid -900 -900 -300 900 900 -200
        play 70 ahead: feet < -150
    )"},
    {"JumpsOverAGap", R"(
        + no_floor
        + solid -500 -500 -200 100 500 0
        + solid 230 -500 -200 900 500 0
        + solid -900 -900 -300 900 900 -200
        play 13 ahead: x > 90, x < 100
        play 1 leap; play 30 ahead: feet = 0 +- 1, x > 240
    )"},
    {"SinksSwimsAndIsSlowerInWater", R"(
        + water 400
        at 0 0 200; play 35: depth = 3, vz = -42 +- 8       # 60 a second, less a third by friction
        play 70 ahead: vx < 230
        at 0 0 100; play 35 jump: feet > 150
    )"},
    {"StaysWhereRockIsAllAround", R"(
        + solid -500 -500 0 500 500 500
        at 0 0 100; play 35 ahead: x = 0, y = 0, feet = 100, vx = 0
    )"},
    {"BeginsAnewWhoFallsOutOfTheWorld", R"(
        + no_floor
        + solid 5000 5000 0 5001 5001 1
        play 875: feet > -40001, vz < 0     # 2,000 units a second at the most
    )"},
};
OBLONG_SCENARIOS(Players, kPlayers);

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

/// Water up to 100 units, and a bank from x = 100 on.
ToyLevel bank(std::int32_t height) {
    ToyLevel toy(100);
    toy.add_model(floor_and({{100, -500, 0, 900, 500, height}}));
    const auto add_node = [&](PlaneIndex plane, NodeChild front, NodeChild back) {
        Node node;
        node.plane = plane;
        node.children = {front, back};
        toy.level.nodes.push_back(node);
        return NodeChild(NodeIndex(toy.level.nodes.count() - 1));
    };
    const Node surface = toy.level.nodes[NodeIndex(0)];
    const NodeChild open = add_node(surface.plane, surface.children[0], surface.children[1]),
                    beyond = add_node(add_plane(toy.level, 2, height), surface.children[0], NodeChild(LeafIndex(0)));
    toy.level.nodes[NodeIndex(0)].plane = add_plane(toy.level, 0, 100);
    toy.level.nodes[NodeIndex(0)].children = {beyond, open};
    return toy;
}

TEST(Player, LeapsOutOfTheWaterOntoABankThatEndsJustAboveIt) {
    const TickInput back{-127, 0, 0, 0, 0};
    for (const auto& [height, input, leaps] :
         {std::tuple{110, kAhead, true}, {150, kAhead, false}, {110, back, false}, {110, kStand, false}}) {
        ToyGame game(bank(height));
        game.state.player.position = world_vector(70, 0, 85);  // the waist is wet, the eyes are not
        double fastest = 0;
        for (int tick = 0; tick < 40; ++tick) {
            game.play(1, input);
            fastest = std::max(fastest, game.state.player.velocity.z.raw / 4096.0);
        }
        EXPECT_EQ(fastest > 200, leaps) << height;
        EXPECT_EQ(game.x() > 110 && std::abs(game.feet() - height) < 0.1, leaps) << height << ' ' << game.feet();
    }
}

TEST(Player, HostileInputsStayInTheRoom) {
    ToyGame game(room({{200, -2000, 0, 220, 2000, 900},
                       {-220, -2000, 0, -200, 2000, 900},
                       {-2000, 200, 0, 2000, 220, 900},
                       {-2000, -220, 0, 2000, -200, 900},
                       {-2000, -2000, 200, 2000, 2000, 220}}));
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        const auto any = [&]<class Int>(Int) { return static_cast<Int>(random()); };
        step(game.level, game.state,
             {any(std::int8_t{}), any(std::int8_t{}), any(std::int16_t{}), any(std::int16_t{}),
              static_cast<std::uint8_t>(random() % 2)});
        ASSERT_LE(std::abs(game.x()), 184) << "tick " << i;
        ASSERT_LE(std::abs(game.y()), 184) << "tick " << i;
        ASSERT_GE(game.feet(), 0) << "tick " << i;
    }
}

}  // namespace
}  // namespace oblong::test
