#pragma once

#include <optional>
#include <vector>

#include "game/simulation/game_level.h"

namespace oblong {

// Monsters, weapons and Quake's other items are not in the game, but their effects on the level are: a monster's
// targets are activated at its death, an item's when it is taken. Here that happens once, when the player comes within
// 32 units of the monster's place, or touches the item's box. The place of a monster that waits in a teleporter is the
// teleporter's exit. Where a level has lightning (event_lightning), Chthon (monster_boss) dies of the third stroke
// instead; each stroke needs both electrodes at the same end of their way.

/// The trigger in place of a monster or a pickup (ClassRole); nothing for others, or without an origin. `fires` is left
/// empty. `triggers` are those of the level: only its teleporters are used.
std::optional<Trigger> trigger_left_of(const Entity& entity, const std::vector<Trigger>& triggers);

/// The movers that "target" the name "lightning": Chthon's electrodes. `entities[i]` is that of mover i.
std::vector<std::uint32_t> find_electrodes(const std::vector<const Entity*>& entities);

}  // namespace oblong
