#pragma once

#include <optional>

#include "game/simulation/game_level.h"

namespace oblong {

// The values of entities' keys. A key counts as absent if its value is not a number, or too large: then the default of
// its class holds (usual_text).

/// "origin"; nothing where it is absent, not three numbers, or outside +-kWorldEnd.
std::optional<Position> origin_of(const Entity& entity);

/// "angle" (degrees), or the second number of "angles", as a turn from +x to +y.
Angle yaw_of(const Entity& entity);

/// True if "angle" or "angles" name a direction: 0 names none, 360 is +x.
bool has_direction(const Entity& entity);

/// The direction of "angles" (pitch, yaw, roll) or "angle" (yaw), of length 1. A yaw of -1 is up, -2 is down.
Vec3<Unit> direction_of(const Entity& entity);

/// The number of a key in world units. If it is absent, 0, or beyond +-`largest`, the default of its class, or 0. As in
/// Quake's game code, 0 counts as absent.
World number_of(const Entity& entity, const char* key, std::int32_t largest = kWorldEnd);

/// The key "speed" in world units a second, 1 to 4000, as units in a tick.
World speed_per_tick_of(const Entity& entity);

/// The number of ticks, rounded up, that a key gives in seconds; kForever for less than 0.
std::int32_t ticks_of(const Entity& entity, const char* key);

/// True where one of the bits of "spawnflags" is set.
bool has_flag(const Entity& entity, int flags);

/// True for an entity that is absent in single-player games at Quake's normal skill (spawnflag 512).
inline bool is_left_out(const Entity& entity) {
    return has_flag(entity, 512);
}

/// The box of a brush model at its place in the file.
inline Box model_box(const Level& bsp, ModelIndex model) {
    return box_of(bsp.models[model].box);
}

}  // namespace oblong
