#pragma once

#include <functional>

#include "game/input/tick_input_source.h"
#include "game/simulation/tick_clock.h"
#include "game/view/game_renderer.h"

namespace oblong {

/// A walk's ticks: their clock, their input from the player or a demo, and their states.
class WalkTicks {
  public:
    /// The level outlives it. The first state is that of its start.
    WalkTicks(const GameLevel& level, TickInputSource input);

    /// Called after each tick.
    using AfterTick = std::function<void(const GameState& before, const GameState& after, const TickReport& report)>;

    /// Plays the ticks that are due after `elapsed_us`. `speed_100`: TickClock::advance()'s.
    void advance(std::uint64_t elapsed_us, std::int32_t speed_100, const AfterTick& after_tick);
    /// Continues from another state of the level.
    void restore(const GameState& state) { before_ = after_ = state; }

    const GameState& state() const { return after_; }
    /// The state to show now, between the last two states.
    InterpolatedState shown() const { return {before_, after_, clock_.fraction_16()}; }
    /// The camera at the player's eye, with the mouse motion since the last tick.
    Camera camera(Degrees field_of_view) const;
    TickInputSource& input() { return input_; }
    const TickInputSource& input() const { return input_; }

  private:
    const GameLevel& level_;
    TickInputSource input_;
    TickClock clock_;
    GameState before_, after_;
};

}  // namespace oblong
