#pragma once

#include <optional>
#include <vector>

#include "game/simulation/game_level.h"

namespace oblong {

/// "origin"; nothing where it is absent, not three numbers, or outside +-kWorldEnd.
std::optional<Position> origin_of(const Entity& entity);

/// "angle" (degrees), or the second number of "angles", as a turn from +x to +y.
Angle yaw_of(const Entity& entity);

/// The model that "model" names ("*3"), 1 and up; nothing where the level has no such model.
std::optional<ModelIndex> model_of(const Entity& entity, const Level& bsp);

/// How far a mover may travel so that no vertex of the level, moved along, leaves the format of world coordinates.
World longest_travel(const Level& bsp);

/// The mover that an entity describes (func_door, func_plat, func_button), as Quake's game does; nothing for any other
/// entity, for one without a model, and where it would travel further than `longest`. Ignores targets.
std::optional<Mover> mover_of(const Entity& entity, const Level& bsp, World longest);

/// A light that can be switched, and whether it is off at the start.
struct SwitchableLight {
    std::uint64_t style;  ///< the bit of its style
    bool starts_dark;
};

/// As in Quake: a light with a targetname and a style from 32 on, off at the start by spawnflag 1.
std::optional<SwitchableLight> switchable_light_of(const Entity& entity);

/// Doors that touch each other open together: each gets the touch boxes of all doors linked to it. `entities[i]` is
/// that of `movers[i]`.
void link_doors(std::vector<Mover>& movers, const std::vector<const Entity*>& entities, const Level& bsp);

}  // namespace oblong
