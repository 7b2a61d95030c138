// What activates what: targets, delays, counters, relays, monsters. The door far away is one that only others open.

#include <gtest/gtest.h>

#include "tests/game/logic_level.h"
#include "tests/game/scenario.h"

namespace oblong {
namespace {

constexpr test::Scenario kActivations[] = {
    {"ATargetIsActivatedAndAMessageShown", R"(
        + trigger_once 100 -50 0 150 50 64 target=door message="It moves"
        play 35: phase0 = start, message = ""
        stand 120 0: phase0 = leaving, message = "It moves", said_at = 36
    )"},
    {"TwoTargetsAreActivatedInTheirOrder", R"(
        + trigger_once 100 -50 0 150 50 64 target=second target2=door
        + trigger_once 300 -50 0 350 50 64 target2=second
        + func_door 1000 0 0 1010 100 100 angle=-1 targetname=door wait=-1
        + func_door 1100 0 0 1110 100 100 angle=-1 targetname=door wait=-1
        + trigger_relay targetname=second message="Both"
        stand 120 0: phase0 = leaving, phase1 = leaving, message = "Both"
        stand 320 0: phase0 = leaving, message = "Both", said_at = 2
    )"},
    {"ADelayIsInSecondsAndHoldsTheMessageToo", R"(
        + trigger_once 100 -50 0 150 50 64 target=door message="It moves" delay=2
        stand 120 0; wait 69: phase0 = start, message = ""
        wait 1: phase0 = leaving, message = "It moves", delayed = 0
    )"},
    {"WhatWasRemovedIsNeitherSolidNorActivatedNorTouched", R"(
        + trigger_once 100 -50 0 150 50 64 killtarget=gone target=door
        + func_wall 300 -50 0 310 50 100 targetname=gone
        + func_door 500 -50 0 510 50 100 targetname=gone angle=-1
        + trigger_once 700 -50 0 750 50 64 targetname=gone target=door
        + item_key1 origin="900 0 24" targetname=gone
        : solid 305 0 24, solid 505 0 24
        stand 120 0: phase0 = start, free 305 0 24, free 505 0 24   # what removes something activates nothing
        stand 720 0: phase0 = start
        stand 900 0: keys = 0, item0 = removed
    )"},
    {"ADoorActivatesItsTargetsAfterItsWholeGroupHasSetOut", R"(
        + func_door 200 -64 0 216 0 128 angle=-1 target=relay
        + func_door 200 0 0 216 64 128 angle=-1 target=count targetname=second
        + trigger_relay targetname=relay killtarget=second
        stand 150 0: phase0 = leaving, phase1 = removed, counted = 1
    )"},
    {"AWallShowsItsOtherFramesByTurns", R"(
        + trigger_multiple 100 -50 0 150 50 64 target=wall wait=1
        + func_wall 300 -50 0 310 50 100 targetname=wall
        stand 120 0: wall0 = other
        at 120 0; play 34: wall0 = other
        play 1: wall0 = there
    )"},
    {"ADoorOfThreeButtonsOpensToTheThirdAndToNothingElse", R"(
        + trigger_counter targetname=count target=door count=3
        + func_button 400 -300 0 410 -260 64 target=count wait=-1 angle=0
        + func_button 400 0 0 410 40 64 target=count wait=-1 angle=0
        + func_button 400 300 0 410 340 64 target=count wait=-1 angle=0
        stand 980 50; play 70: phase0 = start
        at 383 -280; play 10: message = "Only 2 more to go"     # 6 units at 40 a second
        at 383 -280; play 10: message = "Only 2 more to go"     # pressed already
        at 383 320; play 10: message = "Only 1 more to go", phase0 = start
        at 383 20; play 10: message = "Sequence complete", phase0 = leaving
    )"},
    {"ACounterCountsToTwoUnlessItSaysOtherwiseAndIsQuietByItsFlag", R"(
        + trigger_multiple 100 -50 0 150 50 64 target=count wait=0.2
        + trigger_counter targetname=count target=door spawnflags=1
        stand 120 0: phase0 = start
        at 120 0; play 7: phase0 = leaving, message = ""
    )"},
    {"ACounterDoesNotSayNumbersFromFourOn", R"(
        + trigger_once 100 -50 0 150 50 64 target=count
        + trigger_counter targetname=count target=door count=9
        stand 120 0: message = "There are more to go"
    )"},
    {"ARelayPassesOnWithDelayMessageAndRemoval", R"(
        + trigger_once 100 -50 0 150 50 64 target=relay
        + trigger_relay targetname=relay target=door delay=1 message=Now
        + trigger_relay targetname=relay killtarget=wall
        + func_wall 300 -50 0 310 50 100 targetname=wall
        stand 120 0: wall0 = removed, message = ""
        wait 35: message = Now, phase0 = leaving
    )"},
    {"WhatIsNotInTheLevelAtNormalSkillIsNotThere", R"(
        + trigger_once 100 -50 0 150 50 64 target=door spawnflags=512
        + func_wall 300 -50 0 310 50 100 spawnflags=1792        # for deathmatch
        + func_wall 400 -50 0 410 50 100 spawnflags=1280        # neither easy nor hard
        + func_wall 500 -50 0 510 50 100 spawnflags=2048        # not for deathmatch
        : all_triggers = 0, all_walls = 2, free 305 0 24, solid 405 0 24, solid 505 0 24
    )"},
    {"WhatAMonstersDeathWouldOpenOpensWhenThePlayerComesToWhereItStands", R"(
        + trigger_once 100 -50 0 150 50 64
        + func_door 1000 0 0 1010 100 100 angle=-1 targetname=door wait=-1
        + monster_knight origin="600 0 24" target=door targetname=knight
        + monster_knight origin="0 0 24" targetname=door
        stand 120 0: phase0 = start
        stand 519 0: phase0 = start     # 600 - 32 - 32 - 17
        stand 520 0: phase0 = leaving
    )"},
    {"AMonsterThatWaitsInATeleporterStandsAtItsExit", R"(
        + monster_ogre origin="-1500 0 24" target=door
        + trigger_teleport -1550 -50 0 -1450 50 64 targetname=come target=exit
        + info_teleport_destination origin="600 0 0" targetname=exit
        stand -1500 0: phase0 = start
        stand 600 0: phase0 = leaving
    )"},
    {"SoDoesWhatTakingAWeaponWould", R"(
        + weapon_nailgun origin="600 0 24" target=door
        stand 600 0: phase0 = leaving
    )"},
    // Three strokes of lightning, each with both electrodes at the far end of their way.
    {"LightningKillsChthonWithTheThirdStroke", R"(
        + trigger_multiple 100 -50 0 150 50 64 target=bolt wait=1
        + event_lightning targetname=bolt
        + monster_boss origin="600 0 24" target=door
        + func_door 0 -600 0 40 -560 108 angle=-1 wait=-1 target=lightning targetname=electrodes
        + func_door 0 600 0 40 640 108 angle=-1 wait=-1 target=lightning targetname=electrodes
        + trigger_once 100 1000 0 150 1050 64 target=electrodes
        stand 600 0; at 120 0; play 140: phase0 = start     # the electrodes are not in place
        stand 120 1020; wait 36
        stand 120 0; wait 35; stand 120 0; wait 35: phase0 = start
        stand 120 0; wait 35: phase0 != start
        stand 120 0; wait 35        # one more
    )"},
};
OBLONG_SCENARIOS(Activation, kActivations);

TEST(Relays, ALongChainOfRelaysIsFollowedToItsEnd) {
    test::LogicLevel level;
    level.add("trigger_once", {100, -50, 0, 150, 50, 64}, {{"target", "0"}});
    level.add("func_door", {1000, 0, 0, 1010, 100, 100}, {{"angle", "-1"}, {"targetname", "20000"}});
    for (int i = 0; i < 20'000; ++i)
        level.add("trigger_relay", {{"targetname", std::to_string(i)}, {"target", std::to_string(i + 1)}});
    test::LogicGame game(level);
    game.stand_at(120, 0);
    EXPECT_TRUE(game.has_left(0));
}

}  // namespace
}  // namespace oblong
