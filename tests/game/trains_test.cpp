#include <gtest/gtest.h>

#include "tests/game/logic_level.h"

namespace oblong {
namespace {

using test::kStand;
using test::LogicGame;
using test::LogicLevel;
using test::Pairs;
using Phase = MoverState::Phase;

// A plate of 128x128x16 whose least corner goes round a square of 400 units, 100 above the floor, at 200 a second.
LogicLevel with_train(Pairs pairs, const char* last_target = "a") {
    LogicLevel level;
    pairs.insert(pairs.end(), {{"target", "a"}, {"speed", "200"}});
    level.add("func_train", {-600, -600, 100, -472, -472, 116}, pairs);
    level.add("path_corner", {{"targetname", "a"}, {"target", "b"}, {"origin", "300 0 100"}});
    level.add("path_corner", {{"targetname", "b"}, {"target", "c"}, {"origin", "700 0 100"}, {"wait", "2"}});
    level.add("path_corner", {{"targetname", "c"}, {"target", "d"}, {"origin", "700 400 100"}});
    level.add("path_corner", {{"targetname", "d"}, {"target", last_target}, {"origin", "300 400 100"}});
    return level;
}

Position corner_of(const LogicGame& game) {
    return world_vector(-600, -600, 100) + offset_of(game.level.movers[0], game.state.movers[0]);
}

TEST(Train, StartsAtItsFirstCornerGoesRoundAndWaitsWhereItIsTold) {
    LogicLevel level = with_train({});
    LogicGame game(level);
    EXPECT_EQ(corner_of(game), world_vector(300, 0, 100));
    game.wait(7);
    EXPECT_EQ(corner_of(game), world_vector(300, 0, 100)) << "it looks for its corners first";
    game.wait(35);
    EXPECT_NEAR(corner_of(game).x.raw / 4096.0, 500, 0.1);
    game.wait(36);
    EXPECT_EQ(corner_of(game), world_vector(700, 0, 100));
    game.wait(69);
    EXPECT_EQ(corner_of(game), world_vector(700, 0, 100)) << "two seconds";
    game.wait(35);
    EXPECT_NEAR(corner_of(game).y.raw / 4096.0, 200, 6);
    game.wait(36 + 4 + 71 + 4 + 71);  // a tenth of a second at each of the other corners
    EXPECT_NEAR(corner_of(game).x.raw / 4096.0, 300, 6);
    EXPECT_NEAR(corner_of(game).y.raw / 4096.0, 0, 12);
    game.wait(35);
    EXPECT_GT(corner_of(game).x, World::from_int(400)) << "and round again";
}

TEST(Train, WithANameStandsUntilItIsActivated) {
    LogicLevel level = with_train({{"targetname", "train"}});
    level.add("trigger_multiple", {-1000, -50, 0, -950, 50, 64}, {{"target", "train"}});
    LogicGame game(level);
    game.wait(100);
    EXPECT_EQ(corner_of(game), world_vector(300, 0, 100));
    EXPECT_TRUE(game.state.active_movers.empty());
    game.stand_at(-970, 0);
    game.wait(36);
    EXPECT_NEAR(corner_of(game).x.raw / 4096.0, 500, 12);
    game.stand_at(-970, 0);
    game.wait(2);
    EXPECT_EQ(game.phase(0), Phase::Leaving) << "activated again, it goes on";
}

TEST(Train, StopsAtACornerWithoutANextOrThatWaitsForEver) {
    LogicLevel level = with_train({}, "nowhere");
    LogicGame game(level);
    game.wait(35 * 30);
    EXPECT_EQ(corner_of(game), world_vector(300, 400, 100));
    EXPECT_TRUE(game.state.active_movers.empty());
}

TEST(Train, CarriesThePlayer) {
    LogicLevel level = with_train({});
    LogicGame game(level);
    game.put_at(364, 64, 116);
    for (int tick = 0; tick < 7 + 71 + 70 + 60; ++tick) {
        game.play(1, kStand);
        const Position under = game.state.player.position - corner_of(game);
        ASSERT_NEAR(under.x.raw / 4096.0, 64, 0.2) << "tick " << tick;
        ASSERT_NEAR(under.y.raw / 4096.0, 64, 0.2) << "tick " << tick;
        ASSERT_NEAR(game.feet(), 116, 0.2) << "tick " << tick;
    }
    EXPECT_GT(game.x(), 700);
    EXPECT_GT(game.y(), 300);
}

TEST(Train, PushesThePlayerAndWaitsWhereThereIsAWallBehind) {
    LogicLevel level;
    level.add("func_train", {-600, -600, 0, -472, -472, 100}, {{"target", "a"}, {"speed", "200"}});
    level.add("path_corner", {{"targetname", "a"}, {"target", "b"}, {"origin", "300 0 0"}});
    level.add("path_corner", {{"targetname", "b"}, {"target", "a"}, {"origin", "700 0 0"}, {"wait", "-1"}});
    level.add("func_wall", {700, -100, 0, 720, 200, 200});
    LogicGame game(level);
    game.put_at(500, 64);
    game.play(200, kStand);
    EXPECT_NEAR(game.x(), 700 - 16, 200 / 35.0) << "against the wall, but for a tick's way";
    EXPECT_EQ(game.phase(0), Phase::Leaving);
    const double held = game.travelled(0);
    EXPECT_NEAR(held, 700 - 32 - 128 - 300, 6);
    game.play(35, kStand);
    EXPECT_EQ(game.travelled(0), held);
    game.wait(100);
    EXPECT_EQ(game.phase(0), Phase::AtEnd);
}

TEST(Train, WithoutCornersStandsWhereItIs) {
    LogicLevel level;
    level.add("func_train", {300, -64, 0, 400, 64, 100}, {{"target", "nowhere"}});
    LogicGame game(level);
    EXPECT_TRUE(game.level.movers.empty());
    EXPECT_EQ(game.level.walls.size(), 1u);
}

TEST(Train, CornersInHostileOrderAreHarmless) {
    LogicLevel level;
    for (const char* first : {"self", "far", "pair"})
        level.add("func_train", {300, -64, 0, 400, 64, 100}, {{"target", first}, {"speed", "1e9"}});
    level.add("path_corner", {{"targetname", "self"}, {"target", "self"}, {"origin", "0 0 0"}, {"wait", "99999999"}});
    level.add("path_corner", {{"targetname", "far"}, {"target", "end"}, {"origin", "32768 32768 32768"}});
    level.add("path_corner", {{"targetname", "end"}, {"target", "far"}, {"origin", "-32768 -32768 -32768"}});
    level.add("path_corner", {{"targetname", "pair"}, {"target", "pair2"}, {"origin", "5 5 5"}});
    level.add("path_corner", {{"targetname", "pair2"}, {"target", "pair2"}, {"origin", "5 5 5"}});
    LogicGame game(level);
    game.wait(500);
    EXPECT_EQ(game.state.tick, 500);
}

TEST(Train, GoesAsFarAsThe4096thCornerOfAnEndlessChain) {
    LogicLevel source;
    source.add("func_train", {-600, -600, 100, -472, -472, 116}, {{"target", "c0"}});
    for (int i = 0; i < 5000; ++i)
        source.add("path_corner", {{"targetname", "c" + std::to_string(i)},
                                   {"target", "c" + std::to_string(i + 1)},
                                   {"origin", std::to_string(i % 100) + " 0 100"}});
    EXPECT_EQ(LogicGame(source).level.movers[0].legs.size(), 4095u);
}

}  // namespace
}  // namespace oblong
