#pragma once

#include <optional>
#include <string>
#include <unordered_map>

#include "game/simulation/game_level.h"

namespace oblong {

/// The first entity of each targetname.
using EntitiesByName = std::unordered_map<std::string, const Entity*>;

/// The train that a func_train describes: it goes from one path_corner to the next, the least corner of its model at
/// theirs. It waits for their "wait", for ever where that is negative or no corner follows. Nothing for any other
/// entity, one without a model or a first corner, and where it would travel further than `longest`.
std::optional<Mover> train_of(const Entity& entity, const EntitiesByName& by_name, const Level& bsp, World longest);

}  // namespace oblong
