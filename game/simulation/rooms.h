#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "game/simulation/game_level.h"
#include "game/simulation/state.h"

namespace oblong {

/// A room that a level names: the box of a trigger whose message begins with the name and " - ".
struct Room {
    std::string name;  ///< in lower case: "vanishing point"
    Box entrance;
};
std::vector<Room> rooms_of(const GameLevel& level);

/// Puts the player of a state into the entrance of a room, facing the item of its name or else the nearest. Hyphens
/// count as blanks, capitals as small letters. Throws InputError with the rooms there are, if there is none of this
/// name.
void enter_room(std::string_view name, const GameLevel& level, GameState& state);

}  // namespace oblong
