#pragma once

#include <string>
#include <vector>

#include "game/simulation/game_level.h"
#include "game/simulation/state.h"

namespace oblong {

/// What there is to find in a level, as the player is told it; all empty where there are no lenses.
struct Goal {
    std::string title;  ///< "Lenses"
    std::string count;  ///< "5 of 12"
    std::string hint;   ///< once few are missing: "Missing: RAIN (north-east), FOG (north)"
    std::string list;   ///< a line a lens: its name and whether it is found; of the last ones where they are
};
Goal goal_of(const GameLevel& level, const GameState& state);

/// What is said when a tick has taken lenses: "Lenses: 9 of 12. Missing: ..."; empty where it has not.
std::string found_text(const GameLevel& level, const GameState& before, const GameState& after);

/// The lenses that are missing once so few are that the player is led to them; before that none.
std::vector<std::size_t> last_lenses(const GameLevel& level, const GameState& state);

/// Where a place lies as seen from another: "north", "south-west", with "above" or "below" where that is more.
std::string direction_of(const Position& from, const Position& to);

}  // namespace oblong
