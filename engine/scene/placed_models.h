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

/// The brush model that an entity's "model" names ("*3"), 1 and up; nothing where the level has no such model.
std::optional<ModelIndex> brush_model_of(const Entity& entity, const Level& level);

/// The brush models that a level's entities show, at their initial positions. Triggers are not shown, and what turns is
/// by read_level_models(). An entity that names a missing model is ignored.
std::vector<PlacedModel> models_at_rest(const Level& level);

}  // namespace oblong
