#include "tools/map/vis.h"

#include "tools/map/vis_flow.h"
#include "tools/map/vis_narrow.h"
#include "tools/map/vis_rows.h"

namespace oblong::map {
namespace {

// Rows hold a bit for each leaf of the file from leaf 1 on.
std::vector<int> rows_of_leaves(const std::vector<int>& leaf_indices) {
    std::vector<int> rows;
    for (const int index : leaf_indices) rows.push_back(index - 1);
    return rows;
}

std::vector<bool> leaves_seen_from(int leaf, const VisGraph& graph, const std::vector<BitSet>& seen) {
    std::vector<bool> leaves(graph.portals_of_leaf.size(), false);
    leaves[static_cast<std::size_t>(leaf)] = true;
    BitSet portals(graph.portals.size());
    for (const int out : graph.portals_of_leaf[static_cast<std::size_t>(leaf)]) {
        portals.add(static_cast<std::size_t>(out));
        portals.add_all(seen[static_cast<std::size_t>(out)]);
    }
    for (std::size_t i = 0; i < graph.portals.size(); ++i) {
        if (portals.has(i)) leaves[static_cast<std::size_t>(graph.portals[i].leaf)] = true;
    }
    return leaves;
}

}  // namespace

void add_visibility(BspFile& bsp, const CompiledModel& world, const std::vector<int>& leaf_indices,
                    const PlaneList& planes, bool is_fast) {
    const auto leaf_count = static_cast<std::size_t>(bsp.models.front().visible_leaf_count);
    VisGraph graph = make_vis_graph(world, planes, rows_of_leaves(leaf_indices), leaf_count);
    find_might_see(graph);
    std::vector<BitSet> seen;
    if (is_fast) {
        for (const VisPortal& portal : graph.portals) seen.push_back(portal.might_see);
    } else {
        narrow_might_see(graph);
        seen = find_seen_portals(graph);
    }
    for (std::size_t leaf = 0; leaf < leaf_count; ++leaf) {
        bsp.leaves[leaf + 1].visibility_offset = static_cast<int>(bsp.visibility.size());
        bsp.visibility += packed_row(leaves_seen_from(static_cast<int>(leaf), graph, seen));
    }
}

}  // namespace oblong::map
