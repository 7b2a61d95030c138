#pragma once

#include "game/simulation/game_level.h"
#include "game/simulation/state.h"

namespace oblong {

/// True if a level can have such a state: its lists are as long as the level's, its indices lead to something, and its
/// numbers are in the ranges that step() keeps them in. What is not is never stepped or drawn.
bool is_consistent(const GameLevel& level, const GameState& state);

}  // namespace oblong
