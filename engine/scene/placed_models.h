#pragma once

#include <optional>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// A brush model at its place: model 1 and up of the level, moved by `offset`.
struct PlacedModel {
    ModelIndex model;
    Vec3<World> offset;
    bool is_switched = false;  ///< shows the other frames of its animated textures, as a pressed button does
    constexpr bool operator==(const PlacedModel&) const = default;
};

using PlacedIndex = Index<PlacedModel>;  ///< of a scene's models

/// The brush model named by an entity's key "model" ("*3"), 1 and up; none if the level has no such model.
std::optional<ModelIndex> brush_model_of(const Entity& entity, const Level& level);

/// The brush models of a level's entities at their initial positions. Left out are triggers, which are not shown,
/// rotating models, which read_level_models() reads, and entities that name a missing model.
std::vector<PlacedModel> models_at_rest(const Level& level);

}  // namespace oblong
