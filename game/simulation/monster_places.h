#pragma once

#include <optional>
#include <vector>

#include "game/simulation/game_level.h"

namespace oblong {

// Monsters, weapons and Quake's other items stay out of the game, but not what they do to the level: a monster's
// targets are activated at its death, an item's when it is taken. Here that happens once, when the player comes to
// where the thing stands: to within 32 units of a monster, and to an item's own box. A monster that waits in a
// teleporter until something activates it stands at the teleporter's exit. Chthon (monster_boss) dies of the lightning
// (event_lightning) instead, where a level has it: of the third stroke, each with both electrodes at the same end of
// their way.

/// The trigger that is left of a monster or a pickup (ClassRole); nothing of others, and where it has no origin.
/// Without what it fires. `triggers` are those of the level: the teleporters among them.
std::optional<Trigger> trigger_left_of(const Entity& entity, const std::vector<Trigger>& triggers);

/// The movers that "target" the name "lightning": Chthon's electrodes. `entities[i]` is that of mover i.
std::vector<std::uint32_t> find_electrodes(const std::vector<const Entity*>& entities);

}  // namespace oblong
