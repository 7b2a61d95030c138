#include "tools/map/vis/portal_graph.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "tools/map/source/winding.h"

namespace oblong::map {
namespace {

constexpr double kFrontEpsilon = 1e-6;

bool has_point_in_front(const Winding& winding, const Plane& plane) {
    return std::any_of(winding.begin(), winding.end(),
                       [&](const Point& point) { return plane.height_of(point) > kFrontEpsilon; });
}

// Whether a line of sight that passes `first` forwards may then pass `next` forwards.
bool may_follow(const VisPortal& first, const VisPortal& next) {
    return has_point_in_front(next.winding, first.plane) && has_point_in_front(first.winding, next.plane.flipped());
}

// `cluster`: that of the detail node above, or -1.
void assign_cluster(const Tree& tree, int child, int cluster, const std::vector<bool>& is_numbered,
                    Clusters& clusters) {
    if (child < 0) {
        const auto leaf = static_cast<std::size_t>(Tree::leaf_of(child));
        if (!is_numbered[leaf]) return;
        clusters.of_leaf[leaf] = cluster >= 0 ? cluster : static_cast<int>(clusters.count++);
        return;
    }
    const TreeNode& node = tree.node(child);
    if (node.is_detail && cluster < 0) cluster = static_cast<int>(clusters.count++);
    for (const int below : node.children) assign_cluster(tree, below, cluster, is_numbered, clusters);
}

// Where two clusters touch: by node, the cluster in front and the one behind.
std::map<std::tuple<int, int, int>, std::vector<Winding>> openings(const CompiledModel& world,
                                                                   const Clusters& clusters) {
    std::map<std::tuple<int, int, int>, std::vector<Winding>> found;
    for (const Portal& portal : world.portals.portals) {
        const int front = at(clusters.of_leaf, portal.leaves[0]);
        const int back = at(clusters.of_leaf, portal.leaves[1]);
        if (front < 0 || back < 0 || front == back) continue;
        if (is_opaque(world.tree.leaf(portal.leaves[0]).contents)) continue;
        if (is_opaque(world.tree.leaf(portal.leaves[1]).contents)) continue;
        found[{portal.node, front, back}].push_back(portal.winding);
    }
    return found;
}

VisPortal make_portal(const Winding& winding, const Plane& plane, int cluster) {
    VisPortal portal{winding, plane, cluster, middle(winding), 0, BitSet{}};
    for (const Point& point : winding) portal.radius = std::max(portal.radius, length(point - portal.centre));
    return portal;
}

}  // namespace

Clusters cluster_leaves(const Tree& tree, const std::vector<bool>& is_numbered) {
    Clusters clusters{std::vector<int>(tree.leaves.size(), -1), 0};
    assign_cluster(tree, tree.root, -1, is_numbered, clusters);
    return clusters;
}

VisGraph make_vis_graph(const CompiledModel& world, const PlaneList& planes, const Clusters& clusters) {
    VisGraph graph;
    graph.portals_of_cluster.resize(clusters.count);
    for (auto& [place, windings] : openings(world, clusters)) {
        const auto [node, front, back] = place;
        const Plane& plane = planes[world.tree.node(node).plane];
        for (const Winding& winding : merged(std::move(windings))) {
            const int index = static_cast<int>(graph.portals.size());
            at(graph.portals_of_cluster, back).push_back(index);
            graph.portals.push_back(make_portal(winding, plane, front));
            at(graph.portals_of_cluster, front).push_back(index + 1);
            graph.portals.push_back(make_portal(winding, plane.flipped(), back));
        }
    }
    return graph;
}

void find_might_see(VisGraph& graph) {
    for (VisPortal& from : graph.portals) {
        from.might_see = BitSet(graph.portals.size());
        flood_portals(graph, from.cluster, from.might_see,
                      [&](std::size_t i) { return may_follow(from, graph.portals[i]); });
    }
}

}  // namespace oblong::map
