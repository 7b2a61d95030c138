#include "tools/map/vis_portals.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "tools/map/merge.h"

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

void flood(VisGraph& graph, VisPortal& from) {
    from.might_see = BitSet(graph.portals.size());
    std::vector<bool> is_reached(graph.portals_of_cluster.size(), false);
    std::vector<int> clusters{from.cluster};
    is_reached[static_cast<std::size_t>(from.cluster)] = true;
    for (std::size_t done = 0; done < clusters.size(); ++done) {
        for (const int index : graph.portals_of_cluster[static_cast<std::size_t>(clusters[done])]) {
            const auto i = static_cast<std::size_t>(index);
            const VisPortal& next = graph.portals[i];
            if (!may_follow(from, next)) continue;
            from.might_see.add(i);
            const auto cluster = static_cast<std::size_t>(next.cluster);
            if (is_reached[cluster]) continue;
            is_reached[cluster] = true;
            clusters.push_back(next.cluster);
        }
    }
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
        const int front = clusters.of_leaf[static_cast<std::size_t>(portal.leaves[0])];
        const int back = clusters.of_leaf[static_cast<std::size_t>(portal.leaves[1])];
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
            graph.portals_of_cluster[static_cast<std::size_t>(back)].push_back(index);
            graph.portals.push_back(make_portal(winding, plane, front));
            graph.portals_of_cluster[static_cast<std::size_t>(front)].push_back(index + 1);
            graph.portals.push_back(make_portal(winding, plane.flipped(), back));
        }
    }
    return graph;
}

void find_might_see(VisGraph& graph) {
    for (VisPortal& portal : graph.portals) flood(graph, portal);
}

}  // namespace oblong::map
