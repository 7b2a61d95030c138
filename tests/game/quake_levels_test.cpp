#include <gtest/gtest.h>

#include "engine/level/bsp_read.h"
#include "game/simulation/collision.h"
#include "game/simulation/step.h"
#include "tests/game/logic_level.h"
#include "tests/game/scenario.h"
#include "tests/support/folders.h"

namespace oblong::test {
namespace {

// In Quake's own levels, the player is put where something is to happen.

constexpr test::Scenario kQuakeLevels[] = {
    {"Dm4sTeleportersLeadToTheirExitsAndItsEndToDm5", R"(
        + dm4.bsp
        stand 624 144 -290: near 456 -864 19
        stand 496 -864 40: near 624 96 -293
        stand -128 -624 -90: near 720 -176 35
        stand 640 -496 -140: near 376 -240 -293
        stand 784 -944 -250: near 368 56 -285, ended = 0
        stand 992 -1120 70: ended = 1, next = dm5
    )"},
    // Not what easy and hard skill and deathmatch have.
    {"E1m7HasWhatNormalSkillHas", R"(
        + e1m7.bsp
        : has_wall18 = 1, has_wall22 = 1
        : has_wall2 = 0, has_wall3 = 0, has_wall4 = 0, has_wall5 = 0, has_wall6 = 0, has_wall7 = 0, has_wall19 = 0
        : has_wall23 = 0, has_mover17 = 1, has_mover21 = 1, has_mover13 = 1
        : has_mover12 = 0, has_mover16 = 0, has_mover20 = 0
    )"},
    {"E1m7sLiftComesUpWithThePlayer", R"(
        + e1m7.bsp
        : phase_of_model1 = start
        stand 1216 64 -32: phase_of_model1 = leaving
        play 60: phase_of_model1 = end, feet = 144 +- 1     # 176 units at 150 a second
    )"},
    // The way through: both electrodes (10 and 11) by their buttons, the lightning three times, the doors (8, 9 and
    // 39), the teleporter, the end. A stroke: to its trigger, for no longer than its wait, and to Chthon's place.
    {"E1m7sLightningOpensTheWayToTheEnd", R"(
        + e1m7.bsp
        stand 304 64 -48; play 35: phase_of_model8 = start      # coming to Chthon's place is not enough
        stand 824 64 148; play 30; stand -448 64 32; play 70: phase_of_model8 = start       # electrodes not in place
        stand 352 376 196; play 35; stand 352 -248 196; play 175: phase_of_model10 = end, phase_of_model11 = end
        stand 824 64 148; play 30; stand -448 64 32; play 945: phase_of_model8 = start
        stand 352 376 196; play 35; stand 352 -248 196; play 175: phase_of_model10 = end, phase_of_model11 = end
        stand 824 64 148; play 30; stand -448 64 32; play 945: phase_of_model8 = start
        stand 352 376 196; play 35; stand 352 -248 196; play 175: phase_of_model10 = end, phase_of_model11 = end
        stand 824 64 148; play 30; stand -448 64 32; play 70
        : phase_of_model8 != start, phase_of_model9 != start, phase_of_model39 != start
        play 175; stand 1024 56 -910: near 944 56 -949
        stand 1016 50 -1040: ended = 1, next = start
    )"},
    {"EndsDoorsMoveAsItsTriggersSay", R"(
        + end.bsp
        stand -448 -440 -370
        : phase_of_model5 = leaving, phase_of_model6 = leaving, phase_of_model9 = start
        stand -720 1440 66: phase_of_model9 = leaving
        stand -628 2744 110: secrets = 1, all_secrets = 1
    )"},
    // The shambler in the pit would raise the wall and call the others, one every ten seconds, each by its own trigger:
    // all that is delayed is set off where it stands.
    {"EndsShamblerSetsOffWhatItsDeathWould", R"(
        + end.bsp
        : phase_of_model28 = start, opened = 0
        stand -688 1808 60: phase_of_model28 = leaving, delayed = 1, opened = 1
        stand 0 8 352; play 3150: opened = 10, delayed = 0
    )"},
    {"EndEndsForWhoComesToShubNiggurath", R"(
        + end.bsp
        stand -752 2032 80: ended = 1, next = ""
    )"},
};
OBLONG_SCENARIOS(QuakeLevels, kQuakeLevels);

TEST(RealLevels, ThePlayerIsNeverInsideSomethingSolid) {
    OBLONG_NEEDS_SHARED_LEVELS();
    for (const char* name : test::kRealLevels) {
        const Level bsp = read_bsp(test::read_shared_file(std::string(name) + ".bsp"));
        const GameLevel level = make_game_level(bsp);
        GameState state = start_of(level);
        RandomRun run;
        Box seen{state.player.position, state.player.position};
        for (int tick = 0; tick < 5000; ++tick) {
            step(level, state, run.next());
            ASSERT_TRUE(is_free(level, state, state.player.position)) << name << " tick " << tick;
            seen = seen.united({state.player.position, state.player.position});
        }
        const Position size = seen.size();
        EXPECT_GT(std::max(size.x, size.y), World::from_int(300)) << name << ": the walk got nowhere";
    }
}

}  // namespace
}  // namespace oblong::test
