#include "tools/map/vis/visibility.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "tools/map/source/geometry.h"
#include "tools/map/vis/sight.h"

namespace oblong::map {

namespace {

constexpr const char *kRoughStage = "rough visibility", *kStage = "visibility";
constexpr int kNarrowingRounds = 3;  // each starts from the previous one's sets; a fourth removes hardly any

std::vector<bool> clusters_seen_from(int cluster, const VisGraph& graph, const std::vector<BitSet>& seen) {
    std::vector<bool> clusters(graph.portals_of_cluster.size(), false);
    item(clusters, cluster) = true;
    BitSet portals(graph.portals.size());
    for (const int out : item(graph.portals_of_cluster, cluster)) {
        portals.add(static_cast<std::size_t>(out));
        portals.add_all(item(seen, out));
    }
    portals.for_each_beyond(BitSet(graph.portals.size()),
                            [&](std::size_t i) { item(clusters, graph.portals[i].cluster) = true; });
    return clusters;
}

std::vector<BitSet> find_seen(VisGraph& graph, bool is_fast, const WorkSharing& sharing) {
    sharing.begin(kRoughStage, graph.portals.size() * (is_fast ? 1 : 1 + 2 * kNarrowingRounds));
    find_might_see(graph, sharing, is_fast);
    if (!is_fast) {
        for (int round = 0; round < kNarrowingRounds; ++round) narrow_might_see(graph, sharing);
        sharing.begin(kStage, graph.portals.size());
        return find_seen_portals(graph, sharing);
    }
    std::vector<BitSet> seen;
    for (VisPortal& portal : graph.portals) seen.push_back(std::move(portal.might_see));
    return seen;
}

// The cluster of each leaf of the file, from leaf 1 on.
std::vector<int> clusters_in_file_order(const Clusters& clusters, const std::vector<int>& leaf_indices,
                                        std::size_t leaf_count) {
    std::vector<int> in_order(leaf_count, 0);
    for (std::size_t i = 0; i < leaf_indices.size(); ++i) {
        if (leaf_indices[i] > 0) item(in_order, leaf_indices[i] - 1) = clusters.of_leaf[i];
    }
    return in_order;
}

std::string row_of(int cluster, const VisGraph& graph, const std::vector<BitSet>& seen,
                   const std::vector<int>& cluster_of_leaf) {
    const std::vector<bool> clusters = clusters_seen_from(cluster, graph, seen);
    std::vector<bool> leaves;
    for (const int of_leaf : cluster_of_leaf) leaves.push_back(item(clusters, of_leaf));
    return packed_row(leaves);
}

constexpr double kFrontEpsilon = 1e-6;

bool has_point_in_front(const Winding& winding, const Plane& plane) {
    return std::any_of(winding.begin(), winding.end(),
                       [&](const Point& point) { return plane.height_of(point) > kFrontEpsilon; });
}

// The same for a portal, fast if its middle or all of it is clearly on one side.
bool has_point_in_front(const VisPortal& portal, const Plane& plane) {
    const double height = plane.height_of(portal.centre);
    if (height > 1) return true;
    return height > -portal.radius - 1 && has_point_in_front(portal.winding, plane);
}

// Whether a line of sight through `first` may then pass through `next`, both forwards.
bool may_follow(const VisPortal& first, const VisPortal& next) {
    return has_point_in_front(next, first.plane) && has_point_in_front(first, next.plane.flipped());
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

// The polygons between touching clusters: by node, the cluster in front and the one behind.
std::map<std::tuple<int, int, int>, std::vector<Winding>> openings(const CompiledModel& world,
                                                                   const Clusters& clusters) {
    std::map<std::tuple<int, int, int>, std::vector<Winding>> found;
    for (const Portal& portal : world.portals.portals) {
        const int front = item(clusters.of_leaf, portal.leaves[0]);
        const int back = item(clusters.of_leaf, portal.leaves[1]);
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

std::string packed_row(const std::vector<bool>& leaves) {
    std::string bytes((leaves.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        if (leaves[i]) bytes[i / 8] = static_cast<char>(static_cast<unsigned char>(bytes[i / 8]) | (1u << (i % 8)));
    }
    std::string row;
    for (std::size_t i = 0; i < bytes.size();) {
        row.push_back(bytes[i]);
        if (bytes[i] != 0) {
            ++i;
            continue;
        }
        std::size_t run = 1;
        while (run < 255 && i + run < bytes.size() && bytes[i + run] == 0) ++run;
        row.push_back(static_cast<char>(run));
        i += run;
    }
    return row;
}

std::vector<bool> unpacked_row(const std::string& visibility, int offset, std::size_t leaf_count) {
    if (offset < 0) return std::vector<bool>(leaf_count, true);
    std::vector<bool> leaves;
    for (auto at = static_cast<std::size_t>(offset); leaves.size() < leaf_count; ++at) {
        const auto byte = static_cast<unsigned char>(visibility[at]);
        const std::size_t bits = byte != 0 ? 8 : 8 * static_cast<unsigned char>(visibility[++at]);
        for (std::size_t bit = 0; bit < bits; ++bit) leaves.push_back((byte >> (bit % 8) & 1) != 0);
    }
    leaves.resize(leaf_count);
    return leaves;
}

void add_visibility(BspFile& bsp, const CompiledModel& world, const std::vector<int>& leaf_indices,
                    const PlaneList& planes, bool is_fast, const WorkSharing& sharing, PortalFile* portals) {
    const auto leaf_count = static_cast<std::size_t>(bsp.models.front().visible_leaf_count);
    std::vector<bool> is_numbered;
    for (const int index : leaf_indices) is_numbered.push_back(index > 0);
    const Clusters clusters = cluster_leaves(world.tree, is_numbered);
    VisGraph graph = make_vis_graph(world, planes, clusters);
    if (portals != nullptr) *portals = portal_file(graph);
    const std::vector<BitSet> seen = find_seen(graph, is_fast, sharing);
    const std::vector<int> cluster_of_leaf = clusters_in_file_order(clusters, leaf_indices, leaf_count);
    std::vector<std::string> rows(clusters.count);
    sharing.begin(is_fast ? kRoughStage : kStage, rows.size());
    sharing.for_each(rows.size(), [&](std::size_t cluster) {
        rows[cluster] = row_of(static_cast<int>(cluster), graph, seen, cluster_of_leaf);
    });
    std::vector<int> offsets(clusters.count, -1);  // leaves of a cluster share a row
    for (std::size_t leaf = 0; leaf < leaf_count; ++leaf) {
        int& offset = item(offsets, cluster_of_leaf[leaf]);
        if (offset < 0) {
            offset = static_cast<int>(bsp.visibility.size());
            bsp.visibility += item(rows, cluster_of_leaf[leaf]);
        }
        bsp.leaves[leaf + 1].visibility_offset = offset;
    }
}

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
            item(graph.portals_of_cluster, back).push_back(index);
            graph.portals.push_back(make_portal(winding, plane, front));
            item(graph.portals_of_cluster, front).push_back(index + 1);
            graph.portals.push_back(make_portal(winding, plane.flipped(), back));
        }
    }
    return graph;
}

void find_might_see(VisGraph& graph, const WorkSharing& sharing, bool only_first) {
    sharing.for_each(graph.portals.size(), [&](std::size_t base) {
        VisPortal& from = graph.portals[base];
        from.might_see = BitSet(graph.portals.size());
        flood_portals(
            graph, from.cluster, from.might_see, [&](std::size_t i) { return may_follow(from, graph.portals[i]); },
            only_first);
    });
}

}  // namespace oblong::map
