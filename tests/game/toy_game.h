#pragma once

#include <random>
#include <string>
#include <utility>

#include "game/simulation/step.h"
#include "tests/game/toy_level.h"

namespace oblong::test {

/// A game in a toy level whose player starts with feet at (0, 0, `height`), looking along +x.
struct ToyGame {
    explicit ToyGame(ToyLevel toy_level, std::int32_t height = 0) : toy(std::move(toy_level)) {
        toy.add_entity({{"classname", "info_player_start"}, {"origin", "0 0 " + std::to_string(24 + height)}});
        level = make_game_level(toy.level);
        state = start_of(level);
    }
    ToyGame(const ToyGame&) = delete;  // `level` points into `toy`

    void play(int ticks, const TickInput& input) {
        for (int i = 0; i < ticks; ++i) step(level, state, input);
    }
    double x() const { return state.player.position.x.raw / 4096.0; }
    double y() const { return state.player.position.y.raw / 4096.0; }
    double feet() const { return state.player.position.z.raw / 4096.0 - 24; }
    double travelled(std::size_t mover) const { return state.movers[mover].travelled.raw / 4096.0; }

    ToyLevel toy;
    GameLevel level;
    GameState state;
};

inline constexpr TickInput kStand{}, kAhead{127, 0, 0, 0, 0}, kJump{0, 0, 0, 0, kJumpButton};

/// Runs ahead or askew, turns and jumps, at random.
class RandomRun {
  public:
    TickInput next() {
        TickInput input = kAhead;
        if (random_() % 8 == 0) input.right = 127;
        if (random_() % 20 == 0) input.yaw = static_cast<std::int16_t>(random_());
        if (random_() % 12 == 0) input.buttons = kJumpButton;
        return input;
    }

  private:
    std::mt19937 random_{1};
};

}  // namespace oblong::test
