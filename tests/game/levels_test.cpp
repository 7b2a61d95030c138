#include <gtest/gtest.h>

#include "engine/level/bsp_read.h"
#include "game/simulation/collision.h"
#include "game/simulation/step.h"
#include "tests/game/toy_game.h"
#include "tests/support/folders.h"

namespace oblong::test {
namespace {

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
