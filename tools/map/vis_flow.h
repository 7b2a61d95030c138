#pragma once

#include "tools/map/vis_portals.h"

namespace oblong::map {

/// For each portal, the portals that a line of sight through it may pass afterwards. Follows all chains of portals
/// from each, and cuts what is seen by the planes that separate its first portal from the last passed one (Teller's
/// anti-penumbra, as in Quake's vis). Needs might_see, which
/// is the result for a portal with too many chains; still a superset of what can be seen, but a close one.
std::vector<BitSet> find_seen_portals(VisGraph& graph);

}  // namespace oblong::map
