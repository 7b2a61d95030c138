#include "tools/map/vis_portals.h"

#include <algorithm>

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
    std::vector<bool> is_reached(graph.portals_of_leaf.size(), false);
    std::vector<int> leaves{from.leaf};
    is_reached[static_cast<std::size_t>(from.leaf)] = true;
    for (std::size_t done = 0; done < leaves.size(); ++done) {
        for (const int index : graph.portals_of_leaf[static_cast<std::size_t>(leaves[done])]) {
            const auto i = static_cast<std::size_t>(index);
            const VisPortal& next = graph.portals[i];
            if (!may_follow(from, next)) continue;
            from.might_see.add(i);
            const auto leaf = static_cast<std::size_t>(next.leaf);
            if (is_reached[leaf]) continue;
            is_reached[leaf] = true;
            leaves.push_back(next.leaf);
        }
    }
}

}  // namespace

VisGraph make_vis_graph(const CompiledModel& world, const PlaneList& planes, const std::vector<int>& vis_leaves,
                        std::size_t leaf_count) {
    VisGraph graph;
    graph.portals_of_leaf.resize(leaf_count);
    const auto is_open = [&](int leaf) {
        return vis_leaves[static_cast<std::size_t>(leaf)] >= 0 && !is_opaque(world.tree.leaf(leaf).contents);
    };
    for (const Portal& portal : world.portals.portals) {
        if (!is_open(portal.leaves[0]) || !is_open(portal.leaves[1])) continue;
        const int front = vis_leaves[static_cast<std::size_t>(portal.leaves[0])];
        const int back = vis_leaves[static_cast<std::size_t>(portal.leaves[1])];
        const Plane& plane = planes[world.tree.node(portal.node).plane];
        graph.portals_of_leaf[static_cast<std::size_t>(back)].push_back(static_cast<int>(graph.portals.size()));
        graph.portals.push_back({portal.winding, plane, front, BitSet{}});
        graph.portals_of_leaf[static_cast<std::size_t>(front)].push_back(static_cast<int>(graph.portals.size()));
        graph.portals.push_back({portal.winding, plane.flipped(), back, BitSet{}});
    }
    return graph;
}

void find_might_see(VisGraph& graph) {
    for (VisPortal& portal : graph.portals) flood(graph, portal);
}

}  // namespace oblong::map
