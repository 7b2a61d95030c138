#pragma once

#include <optional>
#include <span>

#include "engine/level/level.h"
#include "engine/math/plane.h"
#include "engine/scene/placed_models.h"

namespace oblong {

/// The first face that a ray meets.
struct PickedFace {
    FaceIndex face;
    PlacedIndex model = PlacedIndex::none();  ///< of those given; none: the world
    RayDistance distance;
    Vec3<World> world_point;
};

/// What a ray from `eye` meets first of a level's faces that face it: those of the world, and of the models at their
/// places. Liquids and sky count, and so do the holes of fences. `direction` has length 1. Through the trees, near side
/// first: a line against the plane of each node that the ray crosses, and the faces on it only.
std::optional<PickedFace> pick_face(const Level& level, std::span<const PlacedModel> models, const Vec3<World>& eye,
                                    const Vec3<Unit>& direction);

/// The entity that a brush model belongs to; null if there is none.
const Entity* entity_of(const Level& level, ModelIndex model);

}  // namespace oblong
