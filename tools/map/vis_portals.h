#pragma once

#include "tools/map/bit_set.h"
#include "tools/map/model.h"

namespace oblong::map {

/// Leaves that are told apart by details only are a cluster: visible sets are found for clusters.
struct Clusters {
    std::vector<int> of_leaf;  ///< by leaf of the tree; -1: solid
    std::size_t count = 0;
};

/// `is_numbered`: tells of each leaf of the tree whether it has a place in the visible sets.
Clusters cluster_leaves(const Tree& tree, const std::vector<bool>& is_numbered);

/// A polygon through which one looks into a cluster.
struct VisPortal {
    Winding winding;
    Plane plane;  ///< faces into the cluster
    int cluster = 0;
    Point centre;  ///< the polygon lies within `radius` of it
    double radius = 0;
    BitSet might_see;  ///< the portals that one looking through this one might look through next
};

/// The clusters, and the ways between them.
struct VisGraph {
    std::vector<VisPortal> portals;                    ///< i and i ^ 1 are the two ways through one polygon
    std::vector<std::vector<int>> portals_of_cluster;  ///< those that lead out of each
};

/// Portals lead each way between clusters whose leaves touch, if both leaves are not opaque.
VisGraph make_vis_graph(const CompiledModel& world, const PlaneList& planes, const Clusters& clusters);

/// Sets might_see of all portals: those that can be reached through portals which lie in front of the one looked
/// through and face away from it. A superset of what can be seen.
void find_might_see(VisGraph& graph);

}  // namespace oblong::map
