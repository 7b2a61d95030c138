#pragma once

#include <vector>

#include "game/simulation/game_level.h"

namespace oblong {

/// Doors that touch each other open together (but for those with spawnflag 4): sets Mover::group and
/// Mover::group_members. `entities[i]` is that of `movers[i]`.
void link_doors(std::vector<Mover>& movers, const std::vector<const Entity*>& entities, const Level& bsp);

/// Gives doors that have been linked what the player touches them by. `is_activated[i]`: something activates mover i.
/// As in Quake's game, a door opens for the player who is near, the whole group as one, unless it wants a key or has a
/// name that something activates. One that would have to be shot wants contact, and so does one that only says
/// something.
void make_doors_touchable(std::vector<Mover>& movers, const std::vector<const Entity*>& entities,
                          const std::vector<bool>& is_activated, const Level& bsp);

}  // namespace oblong
