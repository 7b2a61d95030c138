#include "tools/map/vis_narrow.h"

#include <algorithm>

#include "tools/map/separators.h"

namespace oblong::map {
namespace {

bool reaches_into(const Winding& winding, const std::vector<Plane>& frustum) {
    return std::all_of(frustum.begin(), frustum.end(), [&](const Plane& plane) {
        return std::any_of(winding.begin(), winding.end(),
                           [&](const Point& point) { return plane.height_of(point) > kOnEpsilon; });
    });
}

// Adds to `found` all portals that can be reached from behind `next` within the frustum.
void flood_frustum(const VisGraph& graph, const VisPortal& base, const VisPortal& next,
                   const std::vector<Plane>& frustum, BitSet& found) {
    std::vector<bool> is_reached(graph.portals_of_cluster.size(), false);
    std::vector<int> clusters{next.cluster};
    is_reached[static_cast<std::size_t>(next.cluster)] = true;
    for (std::size_t done = 0; done < clusters.size(); ++done) {
        for (const int index : graph.portals_of_cluster[static_cast<std::size_t>(clusters[done])]) {
            const auto i = static_cast<std::size_t>(index);
            if (!base.might_see.has(i) || !next.might_see.has(i)) continue;
            const VisPortal& portal = graph.portals[i];
            const auto cluster = static_cast<std::size_t>(portal.cluster);
            if (is_reached[cluster] && found.has(i)) continue;
            if (!reaches_into(portal.winding, frustum)) continue;
            found.add(i);
            if (is_reached[cluster]) continue;
            is_reached[cluster] = true;
            clusters.push_back(portal.cluster);
        }
    }
}

BitSet narrowed(const VisGraph& graph, const VisPortal& base) {
    BitSet found(graph.portals.size());
    SightCutter cutter;
    std::vector<Plane> frustum;
    for (const int index : graph.portals_of_cluster[static_cast<std::size_t>(base.cluster)]) {
        const auto i = static_cast<std::size_t>(index);
        if (!base.might_see.has(i)) continue;
        const VisPortal& next = graph.portals[i];
        Winding source = base.winding, target = next.winding;
        cutter.cut_to_front(target, base.plane);
        cutter.cut_to_front(source, next.plane.flipped());
        if (source.empty() || target.empty()) continue;
        found.add(i);
        find_separators(source, target, frustum);
        flood_frustum(graph, base, next, frustum, found);
    }
    return found;
}

}  // namespace

void narrow_might_see(VisGraph& graph) {
    std::vector<BitSet> sets;
    for (const VisPortal& portal : graph.portals) sets.push_back(narrowed(graph, portal));
    // A line of sight runs both ways: portal i ^ 1 is portal i the other way.
    for (std::size_t i = 0; i < sets.size(); ++i) {
        BitSet both(sets.size());
        for (std::size_t k = 0; k < sets.size(); ++k) {
            if (sets[i].has(k) && sets[k ^ 1].has(i ^ 1)) both.add(k);
        }
        graph.portals[i].might_see = std::move(both);
    }
}

}  // namespace oblong::map
