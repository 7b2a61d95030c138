#pragma once

#include <optional>
#include <span>

#include "engine/level/level.h"
#include "engine/math/vec.h"
#include "engine/scene/placed_models.h"

namespace oblong {

/// The first face that a ray meets.
struct PickedFace {
    FaceIndex face;
    PlacedIndex model = PlacedIndex::none();  ///< in `models`; none: the world
    RayDistance distance;
    Vec3<World> world_point;
};

/// The first face that faces `eye` on a ray from there: a face of the world or of a model at its place. Liquids, sky
/// and the holes of fences count too. `direction` has length 1. Walks the trees near side first, and tests only faces
/// on the planes of nodes that the ray crosses.
std::optional<PickedFace> pick_face(const Level& level, std::span<const PlacedModel> models, const Vec3<World>& eye,
                                    const Vec3<Unit>& direction);

/// The entity that a brush model belongs to; null if there is none.
const Entity* entity_of(const Level& level, ModelIndex model);

}  // namespace oblong
