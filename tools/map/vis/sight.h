#pragma once

#include "tools/map/vis/visibility.h"
#include "tools/map/work_sharing.h"

namespace oblong::map {

/// Removes from might_see the portals outside of all views through a portal and its successors: like the whole flow,
/// but only for the first two portals of a chain, so that its cost is bounded.
void narrow_might_see(VisGraph& graph, const WorkSharing& sharing);

/// For each portal, the portals that a line of sight through it may pass afterwards. Follows all chains of portals from
/// each, and clips the view with the planes that separate its first portal from the last passed one (Teller's
/// anti-penumbra, as in Quake's vis). Needs might_see, which is the result for a portal with too many chains. A close
/// superset of the visible portals.
std::vector<BitSet> find_seen_portals(VisGraph& graph, const WorkSharing& sharing);

}  // namespace oblong::map
