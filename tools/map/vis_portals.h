#pragma once

#include "tools/map/bit_set.h"
#include "tools/map/model.h"

namespace oblong::map {

/// A polygon through which one looks into a leaf.
struct VisPortal {
    Winding winding;
    Plane plane;  ///< faces into the leaf
    int leaf = 0;
    BitSet might_see;  ///< the portals that one looking through this one might look through next
};

/// The open leaves of a level (0 to leaf_count - 1), and the ways between them.
struct VisGraph {
    std::vector<VisPortal> portals;                 ///< i and i ^ 1 are the two ways through one polygon
    std::vector<std::vector<int>> portals_of_leaf;  ///< those that lead out of each leaf
};

/// `vis_leaves`: the number of each leaf of the tree, or -1. A portal leads each way between leaves that are not
/// opaque.
VisGraph make_vis_graph(const CompiledModel& world, const PlaneList& planes, const std::vector<int>& vis_leaves,
                        std::size_t leaf_count);

/// Sets might_see of all portals: those that can be reached through portals which lie in front of the one looked
/// through and face away from it. A superset of what can be seen.
void find_might_see(VisGraph& graph);

}  // namespace oblong::map
