#include "tools/map/vis/visibility.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "tools/map/source/geometry.h"

namespace oblong::map {
namespace {

constexpr const char *kRoughStage = "rough visibility", *kStage = "visibility";
constexpr int kNarrowingRounds = 3;  // each starts from the previous one's sets; a fourth removes hardly any

constexpr double kFrontEpsilon = 1e-6;

bool has_point_in_front(const Winding& winding, const Plane& plane) {
    return std::any_of(winding.begin(), winding.end(),
                       [&](const Point& point) { return plane.height_of(point) > kFrontEpsilon; });
}

// Whether a line of sight through `first` may then pass through `next`, both forwards: fast if the middle or all of
// each is clearly on one side of the other's plane.
bool may_follow(const VisPortal& first, const VisPortal& next) {
    const double in_front = first.plane.height_of(next.centre), behind = -next.plane.height_of(first.centre);
    if (in_front <= -next.radius - 1 || behind <= -first.radius - 1) return false;
    return (in_front > 1 || has_point_in_front(next.winding, first.plane)) &&
           (behind > 1 || has_point_in_front(first.winding, next.plane.flipped()));
}

BitSet clusters_seen_from(int cluster, const VisGraph& graph, const std::vector<BitSet>& seen) {
    BitSet clusters(graph.portals_of_cluster.size());
    clusters.add(as_size(cluster));
    BitSet portals(graph.portals.size());
    for (const int out : item(graph.portals_of_cluster, cluster)) {
        portals.add(static_cast<std::size_t>(out));
        portals.add_all(item(seen, out));
    }
    portals.for_each([&](std::size_t i) { clusters.add(as_size(graph.portals[i].cluster)); });
    return clusters;
}

// Sets might_see of all portals: those reachable through portals in front of this one that face away from it. A
// superset of the visible ones.
void find_might_see(VisGraph& graph, const WorkSharing& sharing) {
    sharing.for_each(graph.portals.size(), [&](std::size_t base) {
        VisPortal& from = graph.portals[base];
        from.might_see = BitSet(graph.portals.size());
        flood_portals(graph, from.cluster, from.might_see,
                      [&](std::size_t i) { return may_follow(from, graph.portals[i]); });
    });
}

// The clusters that may be visible from each one; in a draft, by the directions of portals alone.
std::vector<BitSet> find_seen(VisGraph& graph, bool is_fast, const WorkSharing& sharing) {
    std::vector<BitSet> clusters(graph.portals_of_cluster.size()), seen;
    sharing.begin(kRoughStage,
                  is_fast ? graph.portals.size() + clusters.size() : graph.portals.size() * (1 + 2 * kNarrowingRounds));
    find_might_see(graph, sharing);
    if (is_fast) {
        for (VisPortal& portal : graph.portals) seen.push_back(std::move(portal.might_see));
    } else {
        for (int round = 0; round < kNarrowingRounds; ++round) narrow_might_see(graph, sharing);
        sharing.begin(kStage, graph.portals.size() + clusters.size());
        seen = find_seen_portals(graph, sharing);
    }
    sharing.for_each(clusters.size(),
                     [&](std::size_t i) { clusters[i] = clusters_seen_from(static_cast<int>(i), graph, seen); });
    return clusters;
}

struct Clusters {
    std::vector<int> of_leaf;  // by leaf of the tree; -1: solid
    std::size_t count = 0;
};

// The leaves of each cluster, counted from leaf 1 of the file.
std::vector<std::vector<std::size_t>> leaves_of_clusters(const Clusters& clusters,
                                                         const std::vector<int>& leaf_indices) {
    std::vector<std::vector<std::size_t>> leaves(clusters.count);
    for (std::size_t i = 0; i < leaf_indices.size(); ++i)
        if (leaf_indices[i] > 0) item(leaves, clusters.of_leaf[i]).push_back(as_size(leaf_indices[i] - 1));
    return leaves;
}

std::string row_of(const BitSet& clusters, const std::vector<std::vector<std::size_t>>& leaves_of_cluster,
                   std::size_t leaf_count) {
    BitSet leaves(leaf_count);
    clusters.for_each([&](std::size_t cluster) {
        for (const std::size_t leaf : leaves_of_cluster[cluster]) leaves.add(leaf);
    });
    return packed_row(leaves, leaf_count);
}

// `cluster`: that of the detail node above, or -1.
void assign_cluster(const Tree& tree, int child, int cluster, const std::vector<int>& leaf_indices,
                    Clusters& clusters) {
    if (child < 0) {
        const int leaf = Tree::leaf_of(child);
        if (item(leaf_indices, leaf) <= 0) return;
        item(clusters.of_leaf, leaf) = cluster >= 0 ? cluster : static_cast<int>(clusters.count++);
        return;
    }
    const TreeNode& node = tree.node(child);
    if (node.is_detail && cluster < 0) cluster = static_cast<int>(clusters.count++);
    for (const int below : node.children) assign_cluster(tree, below, cluster, leaf_indices, clusters);
}

// The polygons between touching clusters: by node, the cluster in front and the one behind.
std::map<std::tuple<int, int, int>, std::vector<Winding>> openings(const CompiledModel& world,
                                                                   const Clusters& clusters) {
    std::map<std::tuple<int, int, int>, std::vector<Winding>> found;
    for (const Portal& portal : world.portals.portals) {
        const auto [in_front, behind] = portal.leaves;
        const int front = item(clusters.of_leaf, in_front), back = item(clusters.of_leaf, behind);
        if (front < 0 || back < 0 || front == back || is_opaque(world.tree.leaf(in_front).contents) ||
            is_opaque(world.tree.leaf(behind).contents))
            continue;
        found[{portal.node, front, back}].push_back(portal.winding);
    }
    return found;
}

VisPortal make_portal(const Winding& winding, const Plane& plane, int cluster) {
    VisPortal portal{winding, plane, cluster, middle(winding), 0, BitSet{}};
    for (const Point& point : winding) portal.radius = std::max(portal.radius, length(point - portal.centre));
    return portal;
}

// Portals lead in both directions between clusters with touching leaves, if neither leaf is opaque.
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

// Sets the count, and the text if required.
void describe_portals(const VisGraph& graph, PortalFile& file) {
    file.count = graph.portals.size() / 2;
    if (!file.has_text) return;
    file.text = "PRT1\n" + std::to_string(graph.portals_of_cluster.size()) + "\n" + std::to_string(file.count) + "\n";
    for (std::size_t i = 0; i < graph.portals.size(); i += 2) {  // i + 1 is the way back
        const VisPortal& portal = graph.portals[i];
        file.text += std::to_string(portal.winding.size()) + " " + std::to_string(portal.cluster) + " " +
                     std::to_string(graph.portals[i + 1].cluster);
        for (const Point& point : portal.winding) file.text += " (" + point_text(point) + " )";
        file.text += "\n";
    }
}

}  // namespace

std::string packed_row(const BitSet& leaves, std::size_t leaf_count) {
    const std::size_t size = (leaf_count + 7) / 8;
    std::string row;
    for (std::size_t i = 0; i < size;) {
        const std::uint8_t byte = leaves.byte(i);
        row.push_back(static_cast<char>(byte));
        if (byte != 0) {
            ++i;
            continue;
        }
        std::size_t run = 1;
        while (run < 255 && i + run < size && leaves.byte(i + run) == 0) ++run;
        row.push_back(static_cast<char>(run));
        i += run;
    }
    return row;
}

BitSet unpacked_row(const std::string& visibility, int offset, std::size_t leaf_count) {
    const std::size_t size = (leaf_count + 7) / 8;
    BitSet leaves(leaf_count);
    const std::uint32_t last = 255u >> (8 * size - leaf_count);  // the leaves of the last byte
    auto at = static_cast<std::size_t>(offset);
    for (std::size_t i = 0; i < size; ++i) {
        const std::uint8_t byte = offset < 0 ? 255 : static_cast<std::uint8_t>(visibility[at++]);
        leaves.add_byte(i, static_cast<std::uint8_t>(i + 1 < size ? byte : byte & last));
        if (byte == 0) i += static_cast<std::uint8_t>(visibility[at++]) - std::size_t{1};
    }
    return leaves;
}

void add_visibility(BspFile& bsp, const CompiledModel& world, const std::vector<int>& leaf_indices,
                    const PlaneList& planes, bool is_fast, const WorkSharing& sharing, PortalFile* portals) {
    const auto leaf_count = static_cast<std::size_t>(bsp.models.front().visible_leaf_count);
    Clusters clusters{std::vector<int>(leaf_indices.size(), -1)};
    assign_cluster(world.tree, world.tree.root, -1, leaf_indices, clusters);
    VisGraph graph = make_vis_graph(world, planes, clusters);
    if (portals != nullptr) describe_portals(graph, *portals);
    const std::vector<BitSet> seen = find_seen(graph, is_fast, sharing);
    const auto leaves_of_cluster = leaves_of_clusters(clusters, leaf_indices);
    std::vector<std::string> rows(clusters.count);
    sharing.begin(is_fast ? kRoughStage : kStage, rows.size());
    sharing.for_each(rows.size(), [&](std::size_t cluster) {
        rows[cluster] = row_of(seen[cluster], leaves_of_cluster, leaf_count);
    });
    for (std::size_t cluster = 0; cluster < rows.size(); ++cluster) {
        if (leaves_of_cluster[cluster].empty()) continue;
        for (const std::size_t leaf : leaves_of_cluster[cluster])
            bsp.leaves[leaf + 1].visibility_offset = static_cast<int>(bsp.visibility.size());
        bsp.visibility += rows[cluster];
    }
}

WidestView widest_view(const BspFile& bsp) {
    const auto leaf_count = static_cast<std::size_t>(bsp.models.front().visible_leaf_count);
    std::set<int> known;  // offsets of rows, which leaves of a cluster share
    WidestView widest;
    for (std::size_t i = 1; i <= leaf_count; ++i) {
        const FileLeaf& leaf = bsp.leaves[i];
        if (!known.insert(leaf.visibility_offset).second) continue;
        BitSet faces(bsp.faces.size());
        unpacked_row(bsp.visibility, leaf.visibility_offset, leaf_count).for_each([&](std::size_t seen) {
            const FileLeaf& other = bsp.leaves[seen + 1];
            for (int k = 0; k < other.mark_face_count; ++k)
                faces.add(as_size(item(bsp.mark_faces, other.first_mark_face + k)));
        });
        if (faces.count() <= widest.faces) continue;
        widest.faces = faces.count();
        for (int axis = 0; axis < 3; ++axis)
            widest.place[axis] = (item(leaf.box.mins, axis) + item(leaf.box.maxs, axis)) / 2;
    }
    return widest;
}

}  // namespace oblong::map
