#pragma once

#include <span>

#include "engine/level/level.h"
#include "engine/scene/placed_models.h"

namespace oblong {

/// The obstacles of a body of the player's size (Hull::Player): the level, and its brush models at their current
/// places.
struct Surroundings {
    const Level& level;
    std::span<const PlacedModel> models;
};

/// Moves a body by `way`: it slides along obstacles, and climbs steps of 18 units. Returns its place.
Vec3<World> walk_body(const Surroundings& around, const Vec3<World>& from, const Vec3<World>& way);
/// Whether there is a floor less than a unit below.
bool stands_on_floor(const Surroundings& around, const Vec3<World>& at);

}  // namespace oblong
