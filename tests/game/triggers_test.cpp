#include <gtest/gtest.h>

#include "engine/fixed/trig.h"
#include "game/simulation/collision.h"
#include "tests/game/logic_level.h"

namespace oblong {
namespace {

using test::kAhead;
using test::kStand;
using test::LogicGame;
using test::LogicLevel;
using test::Pairs;
using test::Solid;
using Phase = MoverState::Phase;

constexpr Solid kVolume{100, -50, 0, 150, 50, 64};

// A trigger that counts up to 100 in a counter: how often it has fired.
struct CountingGame : LogicGame {
    explicit CountingGame(LogicLevel source) : LogicGame(counted(source)) {
        while (level.triggers.at(counter_).kind != TriggerKind::Counter) ++counter_;
    }
    int fired() const { return 100 - state.triggers.at(counter_).left; }

  private:
    static LogicLevel& counted(LogicLevel& source) {
        return source.add("trigger_counter", {{"targetname", "count"}, {"count", "100"}});
    }
    std::size_t counter_ = 0;
};

LogicLevel with(const char* its_class, Pairs pairs) {
    LogicLevel level;
    pairs.emplace_back("target", "count");
    level.add(its_class, kVolume, std::move(pairs));
    return level;
}

TEST(Trigger, OnceFiresOnce) {
    CountingGame game(with("trigger_once", {}));
    game.put_at(120, 0);
    game.play(100, kStand);
    EXPECT_EQ(game.fired(), 1);
}

TEST(Trigger, MultipleFiresAgainAfterItsWaitOrFifthsOfASecond) {
    CountingGame usual(with("trigger_multiple", {}));
    usual.put_at(120, 0);
    usual.play(7 * 9 + 1, kStand);
    EXPECT_EQ(usual.fired(), 10);
    CountingGame slow(with("trigger_multiple", {{"wait", "0.6"}}));
    slow.put_at(120, 0);
    slow.play(21 * 9 + 1, kStand);
    EXPECT_EQ(slow.fired(), 10);
    CountingGame once(with("trigger_multiple", {{"wait", "-1"}}));
    once.put_at(120, 0);
    once.play(100, kStand);
    EXPECT_EQ(once.fired(), 1);
}

TEST(Trigger, ThatIsNotTouchedFiresOnlyWhenItIsActivated) {
    LogicLevel level = with("trigger_once", {{"spawnflags", "1"}, {"targetname", "hidden"}});
    level.add("trigger_once", {500, -50, 0, 550, 50, 64}, {{"target", "hidden"}});
    CountingGame game(std::move(level));
    game.stand_at(120, 0);
    EXPECT_EQ(game.fired(), 0);
    game.stand_at(520, 0);
    EXPECT_EQ(game.fired(), 1);
}

TEST(Trigger, ThatWouldHaveToBeShotAnswersToWhoComesNear) {
    CountingGame game(with("trigger_multiple", {{"health", "10"}, {"wait", "-1"}}));
    game.stand_at(100 - 32 - 17, 0);
    EXPECT_EQ(game.fired(), 0);
    game.stand_at(100 - 32 - 16, 0);
    EXPECT_EQ(game.fired(), 1);
}

TEST(Trigger, WithAnAngleFiresOnlyForWhoLooksThatWay) {
    CountingGame game(with("trigger_once", {{"angle", "90"}}));
    game.state.player.yaw = degrees_to_angle(Degrees::from_int(-10));
    game.stand_at(120, 0);
    EXPECT_EQ(game.fired(), 0);
    game.state.player.yaw = degrees_to_angle(Degrees::from_int(10));
    game.stand_at(120, 0);
    EXPECT_EQ(game.fired(), 1);
}

TEST(Trigger, OnlyregisteredAlwaysFiresAndKeepsItsMessage) {
    CountingGame game(with("trigger_onlyregistered", {{"message", "Buy it"}}));
    game.put_at(120, 0);
    game.play(100, kStand);
    EXPECT_EQ(game.fired(), 1);
    EXPECT_NE(game.message(), "Buy it");
}

TEST(Secret, IsCountedOnceAndSaysSo) {
    LogicLevel level;
    level.add("trigger_secret", kVolume);
    level.add("trigger_secret", {500, -50, 0, 550, 50, 64}, {{"message", "Well hidden"}});
    LogicGame game(level);
    EXPECT_EQ(game.level.secrets, 2);
    game.put_at(120, 0);
    game.play(100, kStand);
    EXPECT_EQ(game.state.found_secrets, 1);
    EXPECT_EQ(game.message(), "You found a secret place");
    game.stand_at(520, 0);
    EXPECT_EQ(game.state.found_secrets, 2);
    EXPECT_EQ(game.message(), "Well hidden");
}

TEST(Push, ThrowsThePlayerTenTimesAsFastAsItSaysUpToWhatQuakeAllows) {
    LogicLevel level;
    level.add("trigger_push", kVolume, {{"angle", "-1"}, {"speed", "60"}});
    LogicGame game(level);
    game.stand_at(120, 0);
    EXPECT_EQ(game.state.player.velocity, world_vector(0, 0, 600));
    double highest = 0;
    for (int tick = 0; tick < 70; ++tick) {
        game.play(1, kStand);
        highest = std::max(highest, game.feet());
    }
    EXPECT_GT(highest, 200);  // out of the volume at 64 with 600 a second: 600^2 / 2 / 800 = 225 higher
    EXPECT_LT(highest, 300);

    LogicLevel fast;
    fast.add("trigger_push", kVolume, {{"angle", "90"}});
    LogicGame other(fast);
    other.stand_at(120, 0);
    EXPECT_EQ(other.state.player.velocity, world_vector(0, 2000, 0));
}

TEST(Push, OnceByItsFlag) {
    LogicLevel level;
    level.add("trigger_push", kVolume, {{"angle", "-1"}, {"speed", "30"}, {"spawnflags", "1"}});
    LogicGame game(level);
    game.stand_at(120, 0);
    game.play(100, kStand);
    EXPECT_NEAR(game.feet(), 0, 0.1);
    game.stand_at(120, 0);
    EXPECT_NEAR(game.feet(), 0, 0.1);
    EXPECT_EQ(game.state.player.velocity.z, World{});
}

TEST(Push, GoesAlongBothAngles) {
    LogicLevel level;
    level.add("trigger_push", kVolume, {{"angles", "-30 90 0"}, {"speed", "100"}});
    LogicGame game(level);
    game.stand_at(120, 0);
    EXPECT_NEAR(game.state.player.velocity.y.raw / 4096.0, 866, 1);
    EXPECT_NEAR(game.state.player.velocity.z.raw / 4096.0, 500, 1);
}

TEST(Teleporter, FiresItsTargetTooAndIsWhereThePlayerComesInAgain) {
    LogicLevel level = with("trigger_teleport", {});
    level.add("info_teleport_destination", {{"targetname", "count"}, {"origin", "600 0 0"}, {"angle", "90"}});
    CountingGame game(std::move(level));
    // The exit is the first of its name; the counter has the same name, and counts.
    game.stand_at(120, 0);
    EXPECT_EQ(game.fired(), 1);
    EXPECT_NEAR(game.x(), 600, 0.1);
    EXPECT_EQ(game.state.player.velocity.y, World::from_int(300));
    game.wait(10);
    game.play(1, {0, 0, 0, 0, kRespawnButton});
    EXPECT_NEAR(game.x(), 600, 0.1);
    EXPECT_EQ(game.state.player.yaw, kQuarterTurn);
}

TEST(Checkpoint, IsWhereThePlayerComesInAgain) {
    LogicLevel level;
    level.add("info_checkpoint", {{"origin", "600 0 24"}, {"angle", "180"}});
    level.add("info_checkpoint", {{"origin", "-600 0 24"}, {"size", "20 20 20"}});
    LogicGame game(level);
    const TickInput respawn{0, 0, 0, 0, kRespawnButton};
    game.wait(1);
    game.play(1, respawn);
    EXPECT_NEAR(game.x(), 0, 0.1) << "the start";
    game.stand_at(600 + 64 + 17, 0);
    game.play(1, respawn);
    EXPECT_NEAR(game.x(), 0, 0.1) << "not yet there";
    game.stand_at(600 + 64 + 16, 0);
    game.stand_at(-630, 0);
    game.wait(1);
    game.play(1, respawn);
    EXPECT_NEAR(game.x(), 600, 0.1);
    EXPECT_EQ(game.state.player.yaw, kHalfTurn);
    EXPECT_EQ(game.state.player.velocity.x, World{});
}

TEST(Exit, SaysWhereItLeadsAndFires) {
    LogicLevel level;
    level.add("trigger_changelevel", {500, -50, 0, 550, 50, 64}, {{"map", "e1m8"}});
    level.add("trigger_changelevel", kVolume, {{"map", "e1m2"}, {"target", "light"}});
    level.add("light", {{"targetname", "light"}, {"style", "32"}});
    LogicGame game(level);
    EXPECT_EQ(next_map(game.level, game.state), "");
    game.stand_at(120, 0);
    EXPECT_TRUE(game.state.has_ended);
    EXPECT_EQ(next_map(game.level, game.state), "e1m2");
    EXPECT_NE(game.state.dark_styles, 0u);
}

TEST(Trigger, HurtSkillAndMonsterjumpDoNothing) {
    LogicLevel level, empty;
    for (const char* its_class : {"trigger_hurt", "trigger_setskill", "trigger_monsterjump"})
        level.add(its_class, kVolume, {{"dmg", "1000"}, {"message", "3"}});
    LogicGame game(level), plain(empty);
    for (LogicGame* each : {&game, &plain}) {
        each->put_at(50, 0);
        each->play(40, kAhead);
    }
    EXPECT_EQ(hash_of(game.state), hash_of(plain.state));
}

TEST(Gate, OfEpisodesAndOfTheBossAreOpen) {
    LogicLevel level;
    level.add("func_episodegate", {300, -50, 0, 310, 50, 100}, {{"spawnflags", "1"}});
    level.add("func_bossgate", {400, -50, 0, 410, 50, 100});
    level.add("func_illusionary", {500, -50, 0, 510, 50, 100});
    LogicGame game(level);
    for (const int x : {305, 405, 505}) EXPECT_TRUE(is_free(game.level, game.state, world_vector(x, 0, 24))) << x;
    ASSERT_EQ(game.level.walls.size(), 1u) << "an illusionary wall is seen, an open gate is not";
    EXPECT_EQ(game.level.walls[0].model, ModelIndex(3));
}

}  // namespace
}  // namespace oblong
