#pragma once

#include <string>

#include "game/simulation/game_level.h"
#include "game/simulation/state.h"

namespace oblong {

/// The error in a state from outside, as "movers: 3, expected 4"; empty if the game can continue from it: every list
/// has the level's length, every index is in range, every number is one that the game can produce.
std::string find_inconsistency(const GameLevel& level, const GameState& state);

/// True where the game can go on from a state read from outside.
inline bool is_consistent(const GameLevel& level, const GameState& state) {
    return find_inconsistency(level, state).empty();
}

}  // namespace oblong
