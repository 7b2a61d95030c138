// What a game may ask of its player: health, keys of any name, a number of lenses; and timers.

#include <gtest/gtest.h>

#include <set>

#include "tests/game/logic_level.h"
#include "tests/game/scenario.h"

namespace oblong {
namespace {

constexpr test::Scenario kHarms[] = {
    {"TriggerHurtTakesHealthEachSecond", R"(
        + worldspawn health=100
        + trigger_hurt 100 -50 0 150 50 64
        + trigger_hurt 500 -50 0 550 50 64 dmg=30
        stand 120 0: health = 95
        play 34: health = 95
        play 1: health = 90
        stand 520 0: health = 60, status = "Health 60"
    )"},
    {"NothingHurtsWhereTheWorldHasNoHealth", R"(
        + lava 40
        + trigger_hurt 100 -50 0 150 50 64 dmg=1000
        + item_health origin="300 0 24" message="Food"
        : all_items = 0, all_triggers = 1
        at 120 0; play 70: ended = 0, status = ""
        stand 300 0: message = "Food"
    )"},
    {"WhoDiesBeforeACheckpointHasLost", R"(
        + worldspawn health=50
        + trigger_hurt 100 -50 0 150 50 64 dmg=1000
        stand 120 0: health = 0, ended = 1, lost = 1, at_end = "You did not survive.", next = ""
        play 10 ahead: x = 120
    )"},
    {"WhoDiesLaterGoesBackToTheCheckpoint", R"(
        + worldspawn health=50
        + info_checkpoint origin="-500 0 24" size="64 64 64"
        + trigger_hurt 100 -50 0 150 50 64 dmg=20
        stand -500 0: message = ""
        at 120 0; play 71: lost = 0, health = 50, x = -500, message = "You did not survive.", said_at = 72
    )"},
    {"WhoReachesTheEndDyingHasWon", R"(
        + worldspawn health=50
        + trigger_hurt 100 -50 0 150 50 64 dmg=50
        + trigger_changelevel 100 -50 0 150 50 64 map=e1m2 message="Well done"
        stand 120 0: ended = 1, lost = 0, at_end = "Well done", next = "e1m2"
    )"},
    {"LavaBurnsTheFeet", R"(
        + worldspawn health=100
        + lava 20       # feet at 0: 4 units above the player's middle it would reach the waist
        play 6: depth = 1, health = 100
        play 1: health = 90
        play 28: health = 50
    )"},
    {"LavaBurnsWhoWadesTwiceAsMuch", R"(
        + worldspawn health=100
        + lava 40
        play 7: depth = 2, health = 80
        play 28: lost = 1
    )"},
    {"SlimeBurnsWhoDivesTwelveASecond", R"(
        + worldspawn health=100
        + slime 60
        play 34: depth = 3, health = 100
        play 1: health = 88
    )"},
    {"WaterDoesNotBurn", R"(
        + worldspawn health=100
        + water 60
        play 700: depth = 3, health = 100
    )"},
    {"HealthIsTakenByTheHurtAlone", R"(
        + worldspawn health=100
        + trigger_hurt 100 -50 0 150 50 64 dmg=60
        + item_health origin="300 0 24"
        + item_health origin="600 0 24" spawnflags=1 message="An apple"
        + item_health origin="900 0 24" spawnflags=2
        stand 300 0: item0 = there
        stand 120 0: health = 40
        stand 300 0: health = 65, item0 = taken, message = "You receive 25 health"
        stand 600 0: health = 80, message = "An apple"
        stand 900 0: health = 100, item2 = taken
    )"},
    {"ADoorHurtsWhoIsInItsWay", R"(
        + worldspawn health=100
        + func_door 200 -64 0 216 64 128 angle=-1 wait=0.1 speed=400 spawnflags=4
        untouchable 0; activate 0; play 12; at 208 0 1
        play 14: phase0 = end, health = 98      # it turned back once
    )"},
    {"ATrainHurtsTwiceASecond", R"(
        + worldspawn health=100
        + solid -48 -64 0 -32 64 128
        + func_train 40 -64 0 104 64 64 target=a dmg=3
        + path_corner origin="40 -64 0" targetname=a target=b
        + path_corner origin="-200 -64 0" targetname=b target=a
        play 33: health = 100, x < -14, x > -17      # between train and wall since about tick 26
        play 1: health = 97         # 2 * 17
        play 16: health = 97
        play 1: health = 94
    )"},
    {"ActivationSwitchesWhatHurts", R"(
        + worldspawn health=100
        + trigger_hurt 100 -50 0 150 50 64 spawnflags=1 targetname=steam
        + trigger_once 500 -50 0 550 50 64 target=steam
        + trigger_once 800 -50 0 850 50 64 target=steam
        at 120 0; play 40: health = 100
        stand 520 0; stand 120 0: health = 95
        stand 820 0; at 120 0; play 40: health = 95
    )"},
};
OBLONG_SCENARIOS(Harm, kHarms);

constexpr test::Scenario kLocks[] = {
    {"AKeyOfAnyNameOpensTheDoorsOfThisName", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 keyname="red key"
        + func_door 200 400 0 216 500 128 angle=-1 keyname="blue key"
        + item_key_custom origin="-300 0 24" keyname="red key"
        stand 183 0: message = "You need the red key", phase0 = start
        stand -300 0: keys = 4, message = "You have the red key", status = "red key"
        wait 70; stand 183 450: message = "You need the blue key", phase1 = start
        stand 183 0: phase0 = leaving, keys = 0, status = ""
    )"},
    {"QuakesKeysAreTheFirstTwo", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 keyname="gold key"
        + item_key2 origin="-300 0 24"
        stand 183 0: message = "You need the gold key"
        stand -300 0: keys = 2, status = "gold key"
        wait 70; stand 183 0: phase0 = leaving, keys = 0
    )"},
    {"ADoorAsksForLenses", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 count=2
        + item_lens origin="-300 0 24"
        + item_lens origin="-600 0 24"
        stand 183 0: message = "You need 2 lenses", status = "Lenses 0 of 2"
        stand -300 0; wait 70; stand 183 0: phase0 = start, said_at = 73
        stand -600 0; wait 70; stand 183 0: phase0 = leaving, status = "Lenses 2 of 2"
        play 600: phase0 = end      # as one that was unlocked by a key
    )"},
    {"ADoorSaysWhatItAsksForInItsOwnWords", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 count=1 message="Bring glass"
        + func_door 200 400 0 216 500 128 angle=-1 count=1
        + item_lens origin="-300 0 24"
        stand 183 0: message = "Bring glass"
        stand 183 450: message = "You need a lens"
    )"},
    {"TriggersAskForLenses", R"(
        + trigger_once 100 -50 0 150 50 64 target=count count=1
        + trigger_multiple 500 -50 0 550 50 64 target=relay wait=1
        + trigger_relay targetname=relay target=count count=2
        + item_lens origin="-300 0 24"
        + item_lens origin="-600 0 24"
        stand 120 0; stand 520 0: counted = 0
        stand -300 0; stand 120 0: counted = 1
        wait 35; stand 520 0: counted = 1
        stand -600 0; wait 35; stand 520 0: counted = 2
    )"},
};
OBLONG_SCENARIOS(Locks, kLocks);

constexpr test::Scenario kTimers[] = {
    {"FiresEachTimeItsWaitIsOver", R"(
        + func_timer target=count spawnflags=1 wait=0.6
        play 20: counted = 0
        play 1: counted = 1
        play 20: counted = 1
        play 1: counted = 2
    )"},
    {"IsSwitchedByActivation", R"(
        + func_timer targetname=timer target=count
        + trigger_once 100 -50 0 150 50 64 target=timer
        + trigger_once 500 -50 0 550 50 64 target=timer
        play 100: counted = 0
        stand 120 0: counted = 0
        play 1: counted = 1
        play 34: counted = 1
        play 1: counted = 2
        stand 520 0; play 100: counted = 2
    )"},
    {"EndsWhenItIsRemoved", R"(
        + func_timer targetname=timer target=count spawnflags=1
        + trigger_once 100 -50 0 150 50 64 killtarget=timer
        play 36: counted = 1
        at 120 0; play 100: counted = 1
    )"},
};
OBLONG_SCENARIOS(Timers, kTimers);

TEST(Timer, VariesByItsRandomSecondsUpAndDown) {
    test::LogicLevel level;
    level.add("func_timer", {{"spawnflags", "1"}, {"wait", "1"}, {"random", "0.4"}});
    test::LogicGame game(level);
    std::set<std::int64_t> waits;
    std::int64_t last = 35, fired = 0;
    for (game.play(35, test::kStand); game.state.tick < 35'000; ++fired) {
        while (step(game.level, game.state, {}).fired_triggers.empty()) {
        }
        waits.insert(game.state.tick - last);
        last = game.state.tick;
    }
    EXPECT_EQ(waits.size(), 29u) << "each from 35 - 14 to 35 + 14";
    EXPECT_EQ(*waits.begin(), 21);
    EXPECT_EQ(*waits.rbegin(), 49);
    EXPECT_NEAR(static_cast<double>(fired), 1000, 30) << "four standard deviations";
}

TEST(PlayedSounds, BeginAnyTimeBetweenTheirLeastAndTheirMost) {
    test::LogicLevel level;
    level.add("play_sound", {{"origin", "0 0 64"}, {"delay", "1"}, {"wait", "1.4"}});
    test::LogicGame game(level);
    std::set<std::int64_t> waits;
    std::int64_t last = 0;
    while (game.state.tick < 35'000) {
        while (step(game.level, game.state, {}).fired_triggers.empty()) {
        }
        waits.insert(game.state.tick - last);
        last = game.state.tick;
    }
    waits.erase(1);  // the first, at once
    EXPECT_EQ(waits.size(), 15u);
    EXPECT_EQ(*waits.begin(), 35);
    EXPECT_EQ(*waits.rbegin(), 49);
}

TEST(KeyNames, AreUpTo31) {
    test::LogicLevel level;
    const auto add = [&](int i) {
        level.add("item_key_custom", {{"origin", "0 0 0"}, {"keyname", "key " + std::to_string(i)}});
    };
    for (int i = 2; i < 31; ++i) add(i);
    test::ToyLevel toy = test::LogicLevel(level).take();
    EXPECT_EQ(make_game_level(toy.level).items.back().key, std::uint32_t{1} << 30);
    add(31);
    toy = level.take();
    EXPECT_THROW(make_game_level(toy.level), InputError);
}

TEST(Harm, IsHashedAndCannotExceedHealth) {
    test::LogicLevel level;
    level.add("worldspawn", {{"health", "50"}});
    test::LogicGame game(level);
    GameState hurt = game.state;
    hurt.harm.damage = 50;
    EXPECT_NE(hash_of(hurt), hash_of(game.state));
    EXPECT_EQ(find_inconsistency(game.level, hurt), "");
    for (const std::int32_t damage : {-1, 51}) {
        hurt.harm.damage = damage;
        EXPECT_EQ(find_inconsistency(game.level, hurt), "more damage than health");
    }
}

}  // namespace
}  // namespace oblong
