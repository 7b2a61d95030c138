#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/map/tree/bsp_file.h"
#include "tools/map/tree/mesh.h"
#include "tools/map/vis/bit_set.h"
#include "tools/map/work_sharing.h"

namespace oblong::map {

/// The portals between clusters of leaves, for editors.
struct PortalFile {
    bool has_text = true;  ///< set before: whether the text is required
    std::size_t count = 0;
    std::string text;  ///< of a .prt file: "PRT1", the number of clusters and of portals, then a line a portal: number
                       ///< of points, the cluster that sees them run clockwise, the other one, and the points
};

/// A set of leaves as in the file: a bit each, leaf 1 first, lowest bit first; a zero byte is followed by the number of
/// zero bytes that it represents.
std::string packed_row(const BitSet& leaves, std::size_t leaf_count);

/// The first `leaf_count` leaves of the row at `offset`; all of them if it is negative.
BitSet unpacked_row(const std::string& visibility, int offset, std::size_t leaf_count);

/// Gives every leaf of the world the set of leaves potentially visible from it; liquids are transparent. `is_fast`:
/// does not clip lines of sight, so that the sets are larger. `portals`, if not null, receives them.
void add_visibility(BspFile& bsp, const CompiledModel& world, const std::vector<int>& leaf_indices,
                    const PlaneList& planes, bool is_fast, const WorkSharing& sharing, PortalFile* portals);

/// The leaf whose visible set has most faces.
struct WidestView {
    int faces = 0;
    Point place;  ///< the middle of the leaf's box
};
WidestView widest_view(const BspFile& bsp);

/// More faces than a leaf should see: a view shows about a tenth of them, and 350 are what a processor of the time
/// draws.
inline constexpr int kMostInSight = 4000;

/// A portal: the polygon through which a cluster is visible.
struct VisPortal {
    Winding winding;
    Plane plane;  ///< faces into the cluster
    int cluster = 0;
    Point centre;  ///< the polygon is within `radius` of it
    double radius = 0;
    BitSet might_see;  ///< the portals potentially visible through this one
};

/// The portals between clusters: leaves separated only by details form a cluster, for which visible sets are computed.
struct VisGraph {
    std::vector<VisPortal> portals;                    ///< i and i ^ 1 are the two directions through one polygon
    std::vector<std::vector<int>> portals_of_cluster;  ///< those that lead out of each
};

/// Adds to `found` the portals reachable from `cluster` through portals i for which may_pass(i) is true.
template <class MayPass>
void flood_portals(const VisGraph& graph, int cluster, BitSet& found, MayPass may_pass) {
    std::vector<char> is_reached(graph.portals_of_cluster.size(), 0);
    std::vector<int> clusters{cluster};
    item(is_reached, cluster) = 1;
    for (std::size_t done = 0; done < clusters.size(); ++done) {
        for (const int index : item(graph.portals_of_cluster, clusters[done])) {
            const auto i = static_cast<std::size_t>(index);
            const int behind = graph.portals[i].cluster;
            char& is_known = item(is_reached, behind);
            if ((is_known != 0 && found.has(i)) || !may_pass(i)) continue;
            found.add(i);
            if (is_known != 0) continue;
            is_known = 1;
            clusters.push_back(behind);
        }
    }
}

/// Removes from might_see the portals outside of all views through a portal and its successors: like the whole flow,
/// but only for the first two portals of a chain, so that its cost is bounded.
void narrow_might_see(VisGraph& graph, const WorkSharing& sharing);

/// The planes through an edge of one polygon and a corner of the other that have the source on one side and the pass on
/// the other, into `planes`. All points visible from a point of `source` through `pass` are in front of all of them.
void find_separators(const Winding& source, const Winding& pass, std::vector<Plane>& planes);

/// For each portal, the portals that a line of sight through it may pass afterwards. Follows all chains of portals from
/// each, and clips the view with the planes that separate its first portal from the last passed one (Teller's
/// anti-penumbra, as in Quake's vis). Needs might_see, which is the result for a portal with too many chains. A close
/// superset of the visible portals.
std::vector<BitSet> find_seen_portals(VisGraph& graph, const WorkSharing& sharing);

}  // namespace oblong::map
