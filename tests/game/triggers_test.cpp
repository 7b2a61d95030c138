// What fires when the player touches it, and what else is touched: pushes, teleporters, exits, items.

#include <gtest/gtest.h>

#include "tests/game/logic_level.h"
#include "tests/game/scenario.h"

namespace oblong {
namespace {

constexpr test::Scenario kTriggers[] = {
    {"OnceFiresOnce", R"(
        + trigger_once 100 -50 0 150 50 64 target=count
        at 120 0; play 100: counted = 1
    )"},
    {"MultipleFiresAgainAfterAFifthOfASecond", R"(
        + trigger_multiple 100 -50 0 150 50 64 target=count
        at 120 0; play 63: counted = 9
        play 1: counted = 10
    )"},
    {"MultipleFiresAgainAfterItsWait", R"(
        + trigger_multiple 100 -50 0 150 50 64 target=count wait=0.6
        at 120 0; play 189: counted = 9
        play 1: counted = 10
    )"},
    {"MultipleFiresOnceByAWaitOfMinusOne", R"(
        + trigger_multiple 100 -50 0 150 50 64 target=count wait=-1
        at 120 0; play 100: counted = 1
    )"},
    {"OneThatIsNotTouchedFiresOnlyWhenItIsActivated", R"(
        + trigger_once 100 -50 0 150 50 64 spawnflags=1 targetname=hidden target=count
        + trigger_once 500 -50 0 550 50 64 target=hidden
        stand 120 0: counted = 0
        stand 520 0: counted = 1
    )"},
    {"OneThatWouldHaveToBeShotAnswersToWhoComesNear", R"(
        + trigger_multiple 100 -50 0 150 50 64 health=10 wait=-1 target=count
        stand 51 0: counted = 0     # 100 - 32 - 17
        stand 52 0: counted = 1
    )"},
    {"ABreakableGoesWhenItIsTouched", R"(
        + func_breakable 100 -64 0 116 64 128 target=count
        play 10 ahead: wall0 = there, counted = 0
        play 60 ahead: wall0 = removed, counted = 1, x > 116
    )"},
    {"ANamedBreakableGoesWhenItIsActivated", R"(
        + func_breakable 100 -64 0 116 64 128 target=count targetname=glass
        + trigger_once 500 -50 0 550 50 64 target=glass
        + trigger_once 500 500 0 550 550 64 target=glass
        play 60 ahead: wall0 = there, counted = 0, x = 84 +- 0.1
        stand 520 0: wall0 = removed, counted = 1
        stand 520 520: counted = 1
    )"},
    {"ABreakableCanBeTakenAwayInSilence", R"(
        + func_breakable 100 -64 0 116 64 128 target=count targetname=glass
        + trigger_once 500 -50 0 550 50 64 killtarget=glass
        stand 520 0: wall0 = removed, counted = 0
    )"},
    {"WithAnAngleFiresOnlyForWhoLooksThatWay", R"(
        + trigger_once 100 -50 0 150 50 64 angle=90 target=count
        look -10; stand 120 0: counted = 0
        look 10; stand 120 0: counted = 1
    )"},
    {"WithASlantingAngleFiresForWhoLooksWithinARightAngleOfIt", R"(
        + trigger_once 100 -50 0 150 50 64 angle=53 target=count
        look 145; stand 120 0: counted = 0
        look 322; stand 120 0: counted = 0
        look 141; stand 120 0: counted = 1
    )"},
    {"ViewFiresForWhoLooksItsWay", R"(
        + trigger_view 100 -50 0 150 50 64 angles="20 90 0" cone=10 wait=0.2 target=count
        look 90 5; stand 120 0: counted = 0
        look 102 20; stand 120 0: counted = 0     # 12 * cos 20 = 11.3 degrees off
        look 270 20; stand 120 0: counted = 0
        look 99 20; stand 120 0: counted = 1
        look 90 29; wait 10; stand 120 0: counted = 2
    )"},
    {"ViewFiresForWhoLooksAtItsPointFromAnywhereInside", R"(
        + trigger_view 100 -50 0 150 50 64 look_at=sign angles="0 90 0" cone=10 wait=0.2 target=count
        + info_notnull origin="220 100 46" targetname=sign
        look 34 0; stand 120 0: counted = 0        # 45 degrees to the left, at the height of the eye
        look 45 11; stand 120 0: counted = 0
        look 90 0; stand 120 0: counted = 0
        look 36 0; stand 120 0: counted = 1
        wait 10; look 41 0; stand 140 0: counted = 1        # 51.3
        look 42 0; stand 140 0: counted = 2
    )"},
    {"ViewFiresOnceForThePictureOfItsDials", R"(
        + trigger_view 100 -50 0 150 50 64 accuracy=1991 isometric=on target=count
        picture accuracy=1991; stand 120 0: counted = 0
        picture accuracy=bounded isometric=on; stand 120 0: counted = 0
        picture accuracy=1991 wireframe=over zoom=40; stand 300 0: counted = 0
        stand 120 0: counted = 1
        play 40: counted = 1
    )"},
    {"BudgetFiresWhileThePictureIsCheapEnough", R"(
        + trigger_budget 100 -50 0 150 50 64 least=100 most=900 wait=0.2 target=count
        picture work=901; stand 120 0: counted = 0
        picture work=99; stand 120 0: counted = 0
        picture work=900; stand 120 0: counted = 1
        picture work=5000; play 40: counted = 1
        picture work=100; play 8: counted = 3
    )"},
    {"BudgetWaitsForACountedPicture", R"(
        + trigger_budget 100 -50 0 150 50 64 most=900 target=count
        stand 120 0: counted = 0
        picture work=1; stand 120 0: counted = 1
    )"},
    {"OnlyregisteredAlwaysFiresAndKeepsItsMessage", R"(
        + trigger_onlyregistered 100 -50 0 150 50 64 message="Buy it" target=count
        at 120 0; play 100: counted = 1, message != "Buy it"
    )"},
    {"SecretIsCountedOnceAndSaysSo", R"(
        + trigger_secret 100 -50 0 150 50 64
        + trigger_secret 500 -50 0 550 50 64 message="Well hidden"
        : all_secrets = 2
        at 120 0; play 100: secrets = 1, message = "You found a secret place"
        stand 520 0: secrets = 2, message = "Well hidden"
    )"},
    {"PushThrowsThePlayerTenTimesAsFastAsItSays", R"(
        + trigger_push 100 -50 0 150 50 64 angle=-1 speed=60
        stand 120 0: vx = 0, vy = 0, vz = 600
        each 70: feet < 300     # out of the volume at 64 with 600 a second: 600^2 / 2 / 800 = 225 higher
        stand 120 0; play 26: feet > 200
    )"},
    {"PushIsNoFasterThanQuakeAllows", R"(
        + trigger_push 100 -50 0 150 50 64 angle=90
        stand 120 0: vx = 0, vy = 2000, vz = 0
    )"},
    {"PushWorksOnceByItsFlag", R"(
        + trigger_push 100 -50 0 150 50 64 angle=-1 speed=30 spawnflags=1
        stand 120 0: vz = 300
        play 100: feet = 0 +- 0.1
        stand 120 0: feet = 0 +- 0.1, vz = 0
    )"},
    {"PushGoesAlongBothAngles", R"(
        + trigger_push 100 -50 0 150 50 64 angles="-30 90 0" speed=100
        stand 120 0: vy = 866 +- 1, vz = 500 +- 1
    )"},
    // The exit is the first of its name; the counter has the same name, and counts.
    {"TeleporterFiresItsTargetTooAndIsWhereThePlayerComesInAgain", R"(
        + trigger_teleport 100 -50 0 150 50 64 target=count
        + info_teleport_destination targetname=count origin="600 0 0" angle=90
        + trigger_counter targetname=count count=100
        stand 120 0: counted = 1, x = 600 +- 0.1, vy = 300
        wait 10; play 1 respawn: x = 600 +- 0.1, yaw = 90
    )"},
    {"TeleporterLeadsToItsTarget", R"(
        + trigger_teleport 300 -64 0 316 64 128 target=there
        + info_teleport_destination targetname=there origin="-1000 500 0" angle=90
        play 40 ahead: x = -1000 +- 1, y > 500, yaw = 90
    )"},
    // Quake's rule: one with a name works for 0.2 s after it was activated, any other always.
    {"TeleporterWithANameDoesNotWorkByItself", R"(
        + trigger_teleport 100 -64 0 116 64 128 target=there targetname=gate
        + info_teleport_destination targetname=there origin="1000 500 0" angle=90
        play 35 ahead: x > 132, x < 500
    )"},
    {"TeleporterWithANameWorksWhenItIsActivated", R"(
        + trigger_teleport 100 -64 0 116 64 128 target=there targetname=gate spawnflags=3
        + info_teleport_destination targetname=there origin="1000 500 0" angle=90
        + trigger_multiple 20 -64 0 70 64 128 target=gate
        play 35 ahead: x = 1000 +- 1
    )"},
    {"TeleporterIsPassedBeforeWhatActivatesItIsReached", R"(
        + trigger_teleport 100 -64 0 116 64 128 target=there targetname=gate spawnflags=3
        + info_teleport_destination targetname=there origin="1000 500 0" angle=90
        + trigger_multiple 20 -64 0 70 64 128 target=gate
        at 170 0; play 40 back: x < 20, x > -300
    )"},
    {"CheckpointIsWhereThePlayerComesInAgain", R"(
        + info_checkpoint origin="600 0 24" angle=180
        + info_checkpoint origin="-600 0 24" size="20 20 20"
        wait 1; play 1 respawn: x = 0 +- 0.1            # the start
        stand 681 0; play 1 respawn: x = 0 +- 0.1       # not yet there: 600 + 64 + 17
        stand 680 0; stand -630 0; wait 1
        play 1 respawn: x = 600 +- 0.1, yaw = 180, vx = 0
    )"},
    {"ExitSaysWhereItLeadsAndFires", R"(
        + trigger_changelevel 500 -50 0 550 50 64 map=e1m8
        + trigger_changelevel 100 -50 0 150 50 64 map=e1m2 target=light
        : next = ""
        stand 120 0: ended = 1, next = e1m2, dark = 32
    )"},
    {"NothingMovesAfterTheExit", R"(
        + trigger_changelevel 300 -64 0 316 64 128
        play 20 ahead: ended = 0
        play 60 ahead: ended = 1, x < 320
    )"},
    {"GatesOfEpisodesAndOfTheBossAreOpen", R"(
        + func_episodegate 300 -50 0 310 50 100 spawnflags=1
        + func_bossgate 400 -50 0 410 50 100
        + func_illusionary 500 -50 0 510 50 100
        : free 305 0 24, free 405 0 24, free 505 0 24
        : all_walls = 1, model0 = 3         # an illusionary wall is seen, an open gate is not
    )"},
    {"ItemsAreTakenByTouchOnceCountedAndActivateTheirTargets", R"(
        + item_lens origin="300 0 24" target=light message="A lens"
        + item_lens origin="600 0 24" target=light
        + item_key1 origin="900 0 24"
        stand 267 0: lenses = 0, item0 = there
        at 268 0; play 70: lenses = 1, item0 = taken, item1 = there, message = "A lens", said_at = 2, dark = 32
        stand 600 0: dark = "", message = "A lens"       # the second says nothing
    )"},
    {"KeysAreKept", R"(
        + item_key1 origin="300 0 24"
        + item_key2 origin="600 0 24"
        stand 300 0: keys = 1, message = "You have the silver key"
        stand 600 0: keys = 3, message = "You have the gold key"
    )"},
    {"ItemsWithoutAPlaceAreNone", R"(
        + item_lens
        + item_lens origin="1 2"
        + item_lens origin="99999 0 0"
        : all_items = 0
    )"},
};
OBLONG_SCENARIOS(Triggers, kTriggers);

TEST(Trigger, HurtSkillAndMonsterjumpDoNothing) {
    test::LogicLevel level, empty;
    for (const char* its_class : {"trigger_hurt", "trigger_setskill", "trigger_monsterjump"})
        level.add(its_class, {100, -50, 0, 150, 50, 64}, {{"dmg", "1000"}, {"message", "3"}});
    test::LogicGame game(level), plain(empty);
    for (test::LogicGame* each : {&game, &plain}) {
        each->put_at(50, 0);
        each->play(40, test::kAhead);
    }
    EXPECT_EQ(hash_of(game.state), hash_of(plain.state));
}

}  // namespace
}  // namespace oblong
