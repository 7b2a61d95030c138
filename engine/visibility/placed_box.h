#pragma once

#include <vector>

#include "engine/level/level.h"
#include "engine/visibility/box_culler.h"
#include "engine/visibility/leaf_set.h"

namespace oblong {

Vec3<World> middle_of(const LevelBox& box);

/// A box of the level that something stays in, with the world's open leaves that it reaches into.
struct PlacedBox {
    LevelBox box;
    std::vector<LeafIndex> leaves;  ///< none where has_many_leaves
    bool has_many_leaves = false;   ///< too many to be worth a list: some of them nearly always may be seen
};

/// Finds the leaves by descending the tree: once a level, not once a frame. The box is within the limits of LevelBox.
PlacedBox place_box(const Level& level, const LevelBox& box);

/// Whether something in the box may be seen: false where the box is outside the view, or where none of its leaves is
/// among those that may be.
bool may_be_seen(const PlacedBox& placed, const LeafSet& leaves, const BoxCuller& culler);

}  // namespace oblong
