#pragma once

#include <cstdint>
#include <vector>

#include "engine/level/level.h"
#include "engine/scene/face_table.h"
#include "engine/scene/placed_models.h"

namespace oblong {

/// A part of a brush model's face that lies in one leaf of the world.
struct Fragment {
    FaceIndex face;
    LeafIndex leaf;
    PlacedIndex placed;
    std::uint32_t first_corner = 0, corner_count = 0;
};

/// All parts of one placed model.
struct ModelCut {
    std::vector<Fragment> fragments;
    std::vector<Vec3<World>> corners;
};

/// Cuts a model's faces by the planes of the world's tree, down to its leaves; parts in solid are left out. `placed` is
/// the index that its fragments get.
ModelCut cut_model(const Level& level, const PlacedModel& model, PlacedIndex placed, const FaceTable& table);

}  // namespace oblong
