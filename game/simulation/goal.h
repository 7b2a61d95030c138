#pragma once

#include <string>
#include <vector>

#include "game/simulation/game_level.h"
#include "game/simulation/state.h"

namespace oblong {

/// The goal of a level as shown to the player: its lenses. All strings are empty if there are no lenses.
struct Goal {
    std::string title;  ///< "Lenses"
    std::string count;  ///< "5 of 12"
    std::string hint;   ///< when few are missing: "Missing: RAIN (north-east), FOG (north)"
    std::string list;   ///< a line for each lens: its name and whether it is found; for the last ones where they are
};
Goal goal_of(const GameLevel& level, const GameState& state);

/// The message after a tick that has taken lenses: "Lenses: 9 of 12. Missing: ..."; empty if none was taken.
std::string found_text(const GameLevel& level, const GameState& before, const GameState& after);

/// The missing lenses, if they are so few that the player gets hints; empty before that.
std::vector<std::size_t> last_lenses(const GameLevel& level, const GameState& state);

/// The direction of a place from another: "north", "south-west"; "above" or "below" if the difference in height is
/// larger.
std::string direction_of(const Position& from, const Position& to);

}  // namespace oblong
