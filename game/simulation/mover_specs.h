#pragma once

#include <optional>

#include "game/simulation/game_level.h"

namespace oblong {

/// How far a mover may be from its place so that no vertex of the level, moved along, leaves the format of world
/// coordinates.
World longest_travel(const Level& bsp);

/// The mover that an entity describes (func_door, func_door_secret, func_button, func_plat), as Quake's game does;
/// nothing for any other entity, for one without a model, and where it would travel further than `longest`. Without
/// what concerns other entities: linked doors, targets, messages.
std::optional<Mover> mover_of(const Entity& entity, const Level& bsp, World longest);

/// True for an entity that has to be shot to activate it: here it answers to touch.
bool is_shot(const Entity& entity);

/// Where the player touches a mover's model that is where the file has it: from nearby.
Box contact_box(const Box& model);

}  // namespace oblong
