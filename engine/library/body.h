#pragma once

#include <span>

#include "engine/level/level.h"
#include "engine/scene/placed_models.h"

namespace oblong {

/// What a body of the player's size (Hull::Player) may meet: the level, and its brush models where they are now.
struct Surroundings {
    const Level& level;
    std::span<const PlacedModel> models;
};

/// Where a body gets that wants to go on so far: it slides along what it meets, and climbs steps of 18 units.
Vec3<World> walk_body(const Surroundings& around, const Vec3<World>& from, const Vec3<World>& way);
/// Whether something to stand on is less than a unit below.
bool stands_on_floor(const Surroundings& around, const Vec3<World>& at);

}  // namespace oblong
