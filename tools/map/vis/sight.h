#pragma once

#include "tools/map/vis/visibility.h"
#include "tools/map/work_sharing.h"

namespace oblong::map {

/// Takes out of might_see what lies outside of every view through a portal and one of the next: as the whole flow does,
/// but with the first two portals of a chain only, so that its cost has a bound.
void narrow_might_see(VisGraph& graph, const WorkSharing& sharing);

/// For each portal, the portals that a line of sight through it may pass afterwards. Follows all chains of portals
/// from each, and cuts what is seen by the planes that separate its first portal from the last passed one (Teller's
/// anti-penumbra, as in Quake's vis). Needs might_see, which
/// is the result for a portal with too many chains; still a superset of what can be seen, but a close one.
std::vector<BitSet> find_seen_portals(VisGraph& graph, const WorkSharing& sharing);

}  // namespace oblong::map
