#pragma once

#include "game/stage.h"
#include "game/state.h"
#include "game/tick_input.h"

namespace oblong {

/// Moves the world by one tick of 1/35 s. Reads nothing but its arguments: the same inputs give the same states on
/// every machine, at every speed of the display.
void step(const Stage& stage, GameState& state, const TickInput& input);

}  // namespace oblong
