// Doors, buttons, lifts and secret doors: as in Quake.

#include "tests/game/scenario.h"

namespace oblong {
namespace {

constexpr test::Scenario kDoors[] = {
    {"OpenForWhoComesNear", R"(
        + func_door 200 -64 0 216 64 128 angle=-1
        play 35: phase0 = start
        play 105 ahead: x > 400
    )"},
    {"TakeAsLongAsTheirSpeedSaysWaitAndReturn", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 speed=70 wait=2
        activate 0; play 35: travelled0 = 70 +- 0.1
        play 25: phase0 = end, travelled0 = 120 +- 0.01     # 2 units a tick
        play 69: phase0 = end
        play 63: phase0 = start, travelled0 = 0
    )"},
    {"GoAsFarAsTheLipLeavesThemAlongTheFirstAngle", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 angle=270 lip=28 wait=-1
        + func_door 200 -64 0 216 64 128 angle=270 lip=28 wait=-1 spawnflags=4
        activate 0; activate 1; play 70: oz0 = 100, oy0 = 0
        : oy1 = -100, ox1 = 0, oz1 = 0
    )"},
    {"StayOpenByAWaitOfMinusOne", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 wait=-1
        activate 0; play 2000: phase0 = end
    )"},
    {"OpenAgainRatherThanCloseOnThePlayer", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 wait=0.1 speed=400 spawnflags=4
        untouchable 0; activate 0; play 12; at 208 0 1
        play 14: phase0 = end, travelled0 = 120     # it turned back at the tick that would have been its sixth down
        each 200: travelled0 >= 55      # the player is 56 high
        : x = 208 +- 0.01
    )"},
    {"OnAHingeTurnAndAreSolidOnlyWhileTheyAreShut", R"(
        + func_door_rotating 200 -64 0 216 64 128 origin="208 -64 0" targetname=gate distance=90 speed=70 wait=2
        + func_button -80 -32 0 -64 32 64 angle=180 target=gate
        play 70 ahead: x = 184 +- 0.1, travelled0 = 0
        activate 0; play 1: travelled0 = 2 +- 0.01, ox0 = 0, oy0 = 0      # degrees
        play 45: phase0 = end, travelled0 = 90 +- 0.01
        play 20 ahead: x > 240
    )"},
    {"OnAHingeOpenAgainRatherThanShutOnThePlayer", R"(
        + func_door_rotating 200 -64 0 216 64 128 origin="208 -64 0" speed=700 wait=0.1 spawnflags=4
        untouchable 0; activate 0; play 3; at 208 0 1
        play 17: phase0 = end, travelled0 = 90      # it turned back before it was shut
        each 100: travelled0 > 0
        : x = 208 +- 0.01
        at -200 0 1; play 30: phase0 = start, travelled0 = 0
    )"},
    {"OpenTogetherWhereTheyTouch", R"(
        + func_door 200 -64 0 216 0 128 angle=-1
        + func_door 200 0 0 216 64 128 angle=-1
        + func_door 1200 0 0 1216 64 128 angle=-1
        stand 160 -110 1: phase0 = leaving, phase1 = leaving, phase2 = start     # near the first only
    )"},
    {"WithAButtonAnswerToItAlone", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 targetname=gate
        + func_button -80 -32 0 -64 32 64 angle=180 target=gate
        play 70 ahead: x = 184 +- 0.1
        play 105 back: phase0 != start
    )"},
    {"OfSilverOpenToWhoHasTheKeyForGoodAndTakeIt", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 spawnflags=16 wait=1
        + item_key1 origin="-600 0 24"
        + item_key2 origin="-600 400 24"
        stand -600 400: keys = 2
        stand 150 0: message = "You have the gold key"      # from afar the door says nothing
        stand 183 0: message = "You need the silver key", phase0 = start
        stand -600 0: keys = 3
        wait 70; stand 183 0: phase0 = leaving, keys = 2
        wait 700: phase0 = end
    )"},
    {"OfGoldOpenToWhoHasTheKeyForGoodAndTakeIt", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 spawnflags=8 wait=1
        + item_key2 origin="-600 0 24"
        + item_key1 origin="-600 400 24"
        stand -600 400: keys = 1
        stand 150 0: message = "You have the silver key"
        stand 183 0: message = "You need the gold key", phase0 = start
        stand -600 0: keys = 3
        wait 70; stand 183 0: phase0 = leaving, keys = 1
        wait 700: phase0 = end
    )"},
    {"ThatSomethingActivatesSayTheirMessageToWhoTouchesThemUntilTheyOpen", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 targetname=door message="Find the switch" wait=1
        + trigger_multiple -1000 -50 0 -950 50 64 target=door
        stand 183 0: message = "Find the switch", said_at = 1
        at 183 0; play 69: said_at = 1
        play 1: said_at = 71, phase0 = start        # every two seconds
        stand -970 0; wait 1: phase0 = leaving
        wait 175: phase0 = start
        stand 183 0: said_at = 71
    )"},
    {"WhoseNameNothingActivatesOpenToWhoComesNear", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 targetname=door
        stand 150 0: phase0 = leaving
    )"},
    {"ThatWouldHaveToBeShotOpenToATouch", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 health=1
        stand 150 0: phase0 = start
        stand 183 0: phase0 = leaving
    )"},
    {"ToggleByTheirFlagAndStayWhereTheyAre", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 targetname=door spawnflags=32 wait=1
        + trigger_multiple -1000 -50 0 -950 50 64 target=door
        stand -970 0; wait 351: phase0 = end, active = 0
        stand -970 0; wait 1: phase0 = returning
        wait 10; stand -970 0; wait 1: phase0 = leaving     # on its way back, too
    )"},
    {"AnswerToATouchOnceASecond", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 spawnflags=32
        stand 150 0: phase0 = leaving
        at 150 0; play 34: phase0 = leaving
        play 1: phase0 = returning
        play 34: phase0 = returning
        play 1: phase0 = leaving
    )"},
    {"ThatStartOpenShutWhenTheyAreActivated", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 targetname=door spawnflags=1 wait=-1
        + trigger_once -1000 -50 0 -950 50 64 target=door
        : free 208 0 24
        stand -970 0; wait 51: solid 208 0 24, ox0 = 0, oy0 = 0, oz0 = 0
    )"},
    {"ThatStartOpenAndHaveANameAreNotShutByWhoComesNear", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 targetname=door spawnflags=1
        at 150 0; play 35: phase0 = start
    )"},
    {"OfAGroupOpenTogetherHoweverTheyAreActivatedUnlessTheyAreNotLinked", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 targetname=left wait=-1
        + func_door 200 64 0 216 192 128 angle=-1 wait=-1
        + func_door 200 192 0 216 300 128 angle=-1 spawnflags=4
        + trigger_once -1000 -50 0 -950 50 64 target=left
        at 150 0; play 35: phase0 = start, phase1 = start       # one's name shuts both
        stand -970 0; wait 1: phase0 = leaving, phase1 = leaving, phase2 = start
    )"},
    {"StayOpenForAsLongAsTheirWaitAfterTheLastTouchThatCounted", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 wait=2
        at 150 0; play 350: phase0 = end
        wait 34: phase0 = end       # touched no more than a second before
        wait 37: phase0 = returning
    )"},
    {"FireWheneverTheySetOutToOpen", R"(
        + func_door 200 -64 0 216 64 128 angle=-1 target=light wait=1
        stand 150 0: dark = 32
        wait 97: phase0 = returning
        stand 150 0: phase0 = leaving, dark = ""
    )"},
    {"ThatNeverReturnWaitForWhoIsInTheirWay", R"(
        + func_door 200 -64 128 264 64 192 angle=-2 lip=-56 wait=-1 targetname=press
        + trigger_once -1000 -50 0 -950 50 64 target=press
        stand -970 0; wait 1; at 232 0; play 100: phase0 = leaving, travelled0 = 72 +- 3
        wait 35: phase0 = end
    )"},
};
OBLONG_SCENARIOS(Doors, kDoors);

constexpr test::Scenario kButtons[] = {
    {"FireWhenTheyAreInAndComeBackAfterTheirWait", R"(
        + func_button 200 -64 0 244 64 64 angle=0 target=light      # 40 units
        stand 183 0: phase0 = leaving, frame0 = 0
        wait 34: dark = ""
        wait 2: dark = 32, frame0 = 1
        wait 34: phase0 = end
        wait 2: phase0 = returning, frame0 = 0
        wait 36: phase0 = start, travelled0 = 0
    )"},
    {"ThatWouldHaveToBeShotAnswerToTouchToo", R"(
        + func_button 200 -64 0 210 64 64 health=1 angle=0
        stand 183 0: phase0 = leaving
    )"},
};
OBLONG_SCENARIOS(Buttons, kButtons);

// Plates of 128 x 128 that stand with their top at z = 8 below and 136 above.
constexpr test::Scenario kLifts[] = {
    {"WaitBelowCarryThePlayerUpAndComeBack", R"(
        + func_plat 100 -64 0 228 64 136 height=128
        : oz0 = -128
        play 16 ahead
        each 70: feet >= travelled0+7.99        # not into the plate
        : feet = 136 +- 0.1
        play 60 ahead: feet = 0 +- 0.1          # off at the far end
        play 210: travelled0 = 0
    )"},
    {"CarryThePlayerDownWithoutLettingGo", R"(
        + func_plat 100 -64 0 228 64 136 height=128
        play 16 ahead; play 60: feet = 136 +- 0.1
        untouchable 0
        each 175: feet = travelled0+8 +- 0.1
        : travelled0 = 0
    )"},
    {"WithANameWaitAboveUntilTheyAreActivatedAndAreLikeAnyOtherThen", R"(
        + func_plat 100 -64 0 228 64 136 height=128 targetname=lift
        + trigger_multiple -1000 -50 0 -950 50 64 target=lift
        stand 164 0 136; play 175: feet = 136 +- 0.1, active = 0
        stand -970 0; wait 36: phase0 = start
        stand -970 0; wait 1: phase0 = start        # activated once
        stand 164 0 8; play 40: feet = 136 +- 0.1
        stand -970 0; wait 2: phase0 = end
    )"},
    {"StayAboveForThreeSecondsOrOneAfterTheirRiderLeft", R"(
        + func_plat 100 -64 0 228 64 136 height=128 speed=1000
        stand 164 0 8; wait 6: phase0 = end
        wait 103: phase0 = end
        wait 2: phase0 = returning
        wait 10; stand 164 0 8; play 10: phase0 = end
        wait 34: phase0 = end
        wait 2: phase0 = returning
    )"},
    {"AreStartedFromAnyHeight", R"(
        + func_plat 100 -64 0 228 64 136 height=128
        stand 164 0 60: phase0 = leaving
    )"},
    {"WithALowTriggerAreStartedOnlyFromBelow", R"(
        + func_plat 100 -64 0 228 64 136 height=128 spawnflags=1
        stand 164 0 60: phase0 = start
        stand 164 0 8: phase0 = leaving
    )"},
};
OBLONG_SCENARIOS(Lifts, kLifts);

// 64 wide (to the right of the arrow, which points along +x), 32 long.
constexpr test::Scenario kSecretDoors[] = {
    {"GoAsideThenBackWaitAndReturnTheSameWay", R"(
        + func_door_secret 200 -32 0 232 32 96 angle=0 wait=2
        stand 183 0: phase0 = leaving
        wait 45: ox0 = 0, oy0 = -64, oz0 = 0        # 64 units at 50 a second: 44.8 ticks
        wait 35: ox0 = 0, oy0 = -64                 # a second
        wait 23: ox0 = 32, oy0 = -64, oz0 = 0, phase0 = end
        wait 70: ox0 = 32, oy0 = -64
        wait 23: ox0 = 0, oy0 = -64
        wait 35: ox0 = 0, oy0 = -64
        wait 45: ox0 = 0, oy0 = 0, oz0 = 0, phase0 = start
    )"},
    {"GoRightFirst", R"(
        + func_door_secret 200 -32 0 232 32 96 spawnflags=1
        stand 183 0; wait 2100: ox0 = 32, oy0 = -64, oz0 = 0, phase0 = end
    )"},
    {"GoLeftFirstByTheirFlag", R"(
        + func_door_secret 200 -32 0 232 32 96 spawnflags=3
        stand 183 0; wait 2100: ox0 = 32, oy0 = 64, oz0 = 0, phase0 = end
    )"},
    {"GoDownFirstByTheirFlag", R"(
        + func_door_secret 200 -32 0 232 32 96 spawnflags=5
        stand 183 0; wait 2100: ox0 = 32, oy0 = 0, oz0 = -96, phase0 = end
    )"},
    {"GoAsFarAsTheirKeysSay", R"(
        + func_door_secret 200 -32 0 232 32 96 wait=-1 t_width=10 t_length=20
        stand 183 0; wait 2100: ox0 = 20, oy0 = -10, oz0 = 0, phase0 = end
    )"},
    {"WithANameOpenOnlyWhenTheyAreActivated", R"(
        + func_door_secret 200 -32 0 232 32 96 targetname=wall message="A hollow wall"
        + trigger_once -1000 -50 0 -950 50 64 target=wall
        stand 183 0: phase0 = start, message = "A hollow wall", said_at = 1
        at 183 0; play 69: said_at = 1
        play 1: said_at = 71        # every two seconds
        stand -970 0; wait 1: phase0 = leaving
    )"},
    {"WithANameOpenToATouchByTheirFlag", R"(
        + func_door_secret 200 -32 0 232 32 96 targetname=wall spawnflags=16 message="A hollow wall"
        stand 183 0: phase0 = leaving, message = "A hollow wall", said_at < 5
        wait 75; stand 183 0: said_at < 5
    )"},
};
OBLONG_SCENARIOS(SecretDoors, kSecretDoors);

}  // namespace
}  // namespace oblong
