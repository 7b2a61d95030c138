#pragma once

#include <span>

#include "engine/level/trace.h"
#include "engine/scene/placed_models.h"

// How a level's bodies move.

namespace oblong {

/// What is in the way: the level, and its brush models at their current places.
struct Surroundings {
    const Level& level;
    std::span<const PlacedModel> models;
};

/// The shortest trace in the world and in each brush model, and which of them it was.
struct NearestTrace : TraceResult {
    const PlacedModel* model = nullptr;  ///< null: the world
};
NearestTrace trace_all(const Surroundings& around, Hull hull, const Vec3<World>& from, const Vec3<World>& to);

/// Moves a body of the player's size by `way`: it slides along obstacles, and climbs steps of 18 units. Returns its
/// place.
Vec3<World> walk_body(const Surroundings& around, const Vec3<World>& from, const Vec3<World>& way);

/// Whether there is a floor less than a unit below.
bool stands_on_floor(const Surroundings& around, const Vec3<World>& at);

}  // namespace oblong
