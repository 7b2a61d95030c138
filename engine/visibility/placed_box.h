#pragma once

#include <vector>

#include "engine/level/level.h"
#include "engine/visibility/box_culler.h"
#include "engine/visibility/visible_set.h"

namespace oblong {

Vec3<World> middle_of(const LevelBox& box);

/// A box that holds something which does not move, with the world's open leaves that it reaches into.
struct PlacedBox {
    LevelBox box;
    std::vector<LeafIndex> leaves;  ///< empty if has_many_leaves
    bool has_many_leaves = false;   ///< too many to list: one of them is nearly always visible
};

/// Finds the leaves by descending the tree; call it once a level, not once a frame.
PlacedBox place_box(const Level& level, const LevelBox& box);

/// False if the box is outside the view, or none of its leaves is in `leaves`.
bool may_be_seen(const PlacedBox& placed, const LeafSet& leaves, const BoxCuller& culler);

}  // namespace oblong
