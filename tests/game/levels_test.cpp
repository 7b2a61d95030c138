#include <gtest/gtest.h>

#include "engine/level/bsp_read.h"
#include "game/simulation/collision.h"
#include "game/simulation/step.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

// A player who runs, turns and jumps at random, from the start of a real level; everything that a tick may meet.
class RandomWalk {
  public:
    TickInput next() {
        seed_ = seed_ * 6'364'136'223'846'793'005u + 1'442'695'040'888'963'407u;
        const std::uint64_t roll = seed_ >> 33;
        if (roll % 40 == 0) turn_ = static_cast<std::int16_t>(static_cast<int>(roll / 40 % 2001) - 1000);
        const std::uint8_t buttons = roll / 7 % 20 == 0 ? kJumpButton : std::uint8_t{0};
        return {127, static_cast<std::int8_t>(roll / 100 % 3 == 0 ? 127 : 0), turn_, 0, buttons};
    }

  private:
    std::uint64_t seed_ = 1;
    std::int16_t turn_ = 0;
};

TEST(RealLevels, ThePlayerIsNeverInsideSomethingSolid) {
    OBLONG_NEEDS_SHARED_LEVELS();
    for (const char* name : test::kRealLevels) {
        const Level bsp = read_bsp(test::read_shared_file(std::string(name) + ".bsp"));
        const GameLevel level = make_game_level(bsp);
        GameState state = start_of(level);
        RandomWalk walk;
        Box seen{state.player.position, state.player.position};
        for (int tick = 0; tick < 5000; ++tick) {
            step(level, state, walk.next());
            ASSERT_TRUE(is_free(level, state, state.player.position)) << name << " tick " << tick;
            seen = seen.united({state.player.position, state.player.position});
        }
        const Position size = seen.size();
        EXPECT_GT(std::max(size.x, size.y), World::from_int(300)) << name << ": the walk got nowhere";
    }
}

}  // namespace
}  // namespace oblong
