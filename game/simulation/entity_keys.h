#pragma once

#include <optional>

#include "game/simulation/game_level.h"

namespace oblong {

// What the keys of entities say. A key whose value is no number, or too large a one, counts as absent: then it is what
// entity_classes() says of its class.

/// "origin"; nothing where it is absent, not three numbers, or outside +-kWorldEnd.
std::optional<Position> origin_of(const Entity& entity);

/// "angle" (degrees), or the second number of "angles", as a turn from +x to +y.
Angle yaw_of(const Entity& entity);

/// True where "angle" or "angles" name a direction; of 0 they name none, of 360 +x.
bool has_direction(const Entity& entity);

/// The direction of "angles" (pitch, yaw, roll) or "angle" (yaw), of length 1. A yaw of -1 is up, -2 is down.
Vec3<Unit> direction_of(const Entity& entity);

/// The number of a key in world units; the usual one where it is absent, 0, or beyond +-`largest`, 0 if there is none.
/// As in Quake's game code, 0 counts as absent.
World number_of(const Entity& entity, const char* key, std::int32_t largest = kWorldEnd);

/// The key "speed" in world units a second, from 1 to 4000, as way in a tick.
World speed_per_tick_of(const Entity& entity);

/// The number of ticks, rounded up, that a key gives in seconds; kForever for less than 0.
std::int32_t ticks_of(const Entity& entity, const char* key);

/// True where one of the bits of "spawnflags" is set.
bool has_flag(const Entity& entity, int flags);

/// True for an entity that isn't in the level when one plays alone at Quake's normal skill (spawnflag 512).
inline bool is_left_out(const Entity& entity) {
    return has_flag(entity, 512);
}

/// The box of a brush model of the level where the file has it.
inline Box model_box(const Level& bsp, ModelIndex model) {
    return box_of(bsp.models[model].box);
}

}  // namespace oblong
