#include <gtest/gtest.h>

#include "engine/level/bsp_read.h"
#include "game/simulation/collision.h"
#include "game/simulation/state_check.h"
#include "game/simulation/step.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

using Phase = MoverState::Phase;

// A game in one of Quake's own levels, whose player is put where something is to happen.
class QuakeGame {
  public:
    explicit QuakeGame(const char* name) : bsp(read_bsp(test::read_shared_file(std::string(name) + ".bsp"))) {
        level = make_game_level(bsp);
        state = start_of(level);
    }
    void play(int ticks) {
        for (int i = 0; i < ticks; ++i) step(level, state, {});
        ASSERT_EQ(find_inconsistency(level, state), "");
    }
    /// Feet at z.
    void stand_at(std::int32_t x, std::int32_t y, std::int32_t z) {
        state.player = {};
        state.player.position = world_vector(x, y, z + 24);
        play(1);
    }
    bool is_near(std::int32_t x, std::int32_t y, std::int32_t z) const {
        return length_of(state.player.position - world_vector(x, y, z)) < World::from_int(40);
    }
    std::optional<std::size_t> mover(int model) const {
        for (std::size_t i = 0; i < level.movers.size(); ++i)
            if (level.movers[i].model == ModelIndex(model)) return i;
        return {};
    }
    Phase phase(int model) const { return state.movers.at(mover(model).value()).phase; }
    bool has_wall(int model) const {
        return std::any_of(level.walls.begin(), level.walls.end(),
                           [&](const Wall& wall) { return wall.model == ModelIndex(model); });
    }

    Level bsp;
    GameLevel level;
    GameState state;
};

TEST(Dm4, EachTeleporterLeadsToItsExitAndTheEndToDm5) {
    OBLONG_NEEDS_SHARED_LEVELS();
    QuakeGame game("dm4");
    game.stand_at(624, 144, -290);
    EXPECT_TRUE(game.is_near(456, -864, 16 + 27));
    game.stand_at(496, -864, 40);
    EXPECT_TRUE(game.is_near(624, 96, -296 + 27));
    game.stand_at(-128, -624, -90);
    EXPECT_TRUE(game.is_near(720, -176, 32 + 27));
    game.stand_at(640, -496, -140);
    EXPECT_TRUE(game.is_near(376, -240, -296 + 27));
    game.stand_at(784, -944, -250);
    EXPECT_TRUE(game.is_near(368, 56, -288 + 27));
    EXPECT_FALSE(game.state.has_ended);
    game.stand_at(992, -1120, 70);
    EXPECT_TRUE(game.state.has_ended);
    EXPECT_EQ(next_map(game.level, game.state), "dm5");
}

TEST(E1m7, HasWhatNormalSkillHas) {
    OBLONG_NEEDS_SHARED_LEVELS();
    const QuakeGame game("e1m7");
    for (const int model : {18, 22}) EXPECT_TRUE(game.has_wall(model)) << model;  // not at hard skill
    for (const int model : {2, 3, 4, 5, 6, 7, 19, 23}) EXPECT_FALSE(game.has_wall(model)) << model;
    for (const int model : {17, 21, 13}) EXPECT_TRUE(game.mover(model)) << model;
    for (const int model : {12, 16, 20}) EXPECT_FALSE(game.mover(model)) << model;
}

TEST(E1m7, TheLiftComesUpAndGoesDown) {
    OBLONG_NEEDS_SHARED_LEVELS();
    QuakeGame game("e1m7");
    EXPECT_EQ(game.phase(1), Phase::AtStart);
    game.stand_at(1216, 64, 144 - 176);
    EXPECT_EQ(game.phase(1), Phase::Leaving);
    game.play(60);  // 176 units at 150 a second
    EXPECT_EQ(game.phase(1), Phase::AtEnd);
    EXPECT_NEAR(game.state.player.position.z.raw / 4096.0 - 24, 144, 1);
}

// The way through: both electrodes by their buttons, the lightning three times, the doors, the teleporter, the end.
TEST(E1m7, ChthonsLightningOpensTheWayToTheEnd) {
    OBLONG_NEEDS_SHARED_LEVELS();
    QuakeGame game("e1m7");
    game.stand_at(304, 64, -48);
    game.play(35);
    EXPECT_EQ(game.phase(8), Phase::AtStart) << "coming to Chthon's place is not enough";
    const auto strike = [&] {
        game.stand_at(824, 64, 148);
        game.play(30);  // no longer than the button's wait
        game.stand_at(-448, 64, 32);
        game.play(70);
    };
    strike();
    EXPECT_EQ(game.phase(8), Phase::AtStart) << "the electrodes are not in place";
    for (int round = 0; round < 3; ++round) {
        EXPECT_EQ(game.phase(8), Phase::AtStart) << "after " << round << " strokes";
        game.stand_at(352, 376, 196);
        game.play(35);
        game.stand_at(352, -248, 196);
        game.play(35 * 5);
        ASSERT_EQ(game.phase(10), Phase::AtEnd);
        ASSERT_EQ(game.phase(11), Phase::AtEnd);
        strike();
        if (round < 2) game.play(35 * 25);
    }
    for (const int door : {8, 9, 39}) EXPECT_NE(game.phase(door), Phase::AtStart) << door;
    game.play(35 * 5);
    game.stand_at(1024, 56, -910);
    EXPECT_TRUE(game.is_near(944, 56, -952 + 27));
    game.stand_at(1016, 50, -1040);
    EXPECT_TRUE(game.state.has_ended);
    EXPECT_EQ(next_map(game.level, game.state), "start");
}

TEST(End, ItsDoorsMoveAsItsTriggersSay) {
    OBLONG_NEEDS_SHARED_LEVELS();
    QuakeGame game("end");
    game.stand_at(-448, -440, -370);
    EXPECT_EQ(game.phase(5), Phase::Leaving);
    EXPECT_EQ(game.phase(6), Phase::Leaving);
    EXPECT_EQ(game.phase(9), Phase::AtStart);
    game.stand_at(-720, 1440, 66);
    EXPECT_EQ(game.phase(9), Phase::Leaving);
    game.stand_at(-628, 2744, 110);
    EXPECT_EQ(game.state.found_secrets, 1);
    EXPECT_EQ(game.level.secrets, 1);
}

// The shambler in the pit would raise the wall and call the others, one every ten seconds, each by its own trigger.
TEST(End, WhatTheShamblersDeathSetsOffIsSetOffWhereItStands) {
    OBLONG_NEEDS_SHARED_LEVELS();
    QuakeGame game("end");
    EXPECT_EQ(game.phase(28), Phase::AtStart);
    game.stand_at(-688, 1808, 60);
    EXPECT_EQ(game.phase(28), Phase::Leaving);
    ASSERT_EQ(game.state.delayed.size(), 1u);
    const auto opened = [&] {
        return std::count_if(game.state.triggers.begin(), game.state.triggers.end(),
                             [](const TriggerState& trigger) { return trigger.open_until > 0; });
    };
    const auto at_once = opened();
    EXPECT_GE(at_once, 1);
    game.stand_at(0, 8, 352);
    game.play(350 * 9);
    EXPECT_EQ(opened(), at_once + 9);
    EXPECT_TRUE(game.state.delayed.empty());
}

TEST(End, WhoComesToShubNiggurathEndsTheGame) {
    OBLONG_NEEDS_SHARED_LEVELS();
    QuakeGame game("end");
    game.stand_at(-752, 2032, 80);
    EXPECT_TRUE(game.state.has_ended);
    EXPECT_EQ(next_map(game.level, game.state), "");
}

}  // namespace
}  // namespace oblong
