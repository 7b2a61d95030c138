#pragma once

#include <optional>

#include "game/stage.h"

namespace oblong {

/// The mover that an entity describes (func_door, func_plat, func_button), as Quake's game does; nothing for any other
/// entity, and for those without a model of their own. Links between movers are not looked at.
std::optional<Mover> mover_of(const Entity& entity, const Level& level);

/// Doors that touch each other open together: each gets the touch boxes of all that it is linked with. `entities[i]` is
/// that of `movers[i]`.
void link_doors(std::vector<Mover>& movers, const std::vector<const Entity*>& entities, const Level& level);

}  // namespace oblong
