#pragma once

#include <string>
#include <utility>

#include "game/world.h"
#include "tests/game/toy_level.h"

namespace oblong::test {

/// A game in a toy level whose player starts with feet at (0, 0, `height`), looking along +x.
struct ToyGame {
    explicit ToyGame(ToyLevel toy_level, std::int32_t height = 0) : toy(std::move(toy_level)) {
        toy.add_entity({{"classname", "info_player_start"}, {"origin", "0 0 " + std::to_string(24 + height)}});
        stage = make_stage(toy.level);
        state = start_of(stage);
    }
    ToyGame(const ToyGame&) = delete;  // the stage points into the level

    void play(int ticks, const TickInput& input) {
        for (int i = 0; i < ticks; ++i) step(stage, state, input);
    }
    double x() const { return state.player.place.x.raw / 4096.0; }
    double y() const { return state.player.place.y.raw / 4096.0; }
    double feet() const { return state.player.place.z.raw / 4096.0 - 24; }
    double speed() const { return state.player.velocity.x.raw / 4096.0; }
    double travelled(std::size_t mover) const { return state.movers[mover].travelled.raw / 4096.0; }

    ToyLevel toy;
    Stage stage;
    GameState state;
};

inline constexpr TickInput kStand{}, kAhead{127, 0, 0, 0, 0}, kJump{0, 0, 0, 0, kJumpButton};

}  // namespace oblong::test
