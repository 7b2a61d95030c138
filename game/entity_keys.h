#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/level/level.h"
#include "game/state.h"

namespace oblong {

/// The number of a key in world units; `otherwise` where it is absent, no number, or beyond +-`largest`.
World number_of(const Entity& entity, const char* key, std::int32_t otherwise, std::int32_t largest = 32'768);

/// "origin"; nothing where it is absent, no place, or outside the world.
std::optional<Place> origin_of(const Entity& entity);

/// The model that "model" names ("*3"), 1 and up; nothing where there is no such.
std::optional<ModelIndex> model_of(const Entity& entity, const Level& level);

/// The direction of "angle" (degrees; -1 up, -2 down) or of the second number of "angles", of length 1.
Vec3<Unit> direction_of(const Entity& entity);

/// "angle" as a turn.
Angle yaw_of(const Entity& entity);

}  // namespace oblong
