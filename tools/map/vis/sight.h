#pragma once

#include "tools/map/source/geometry.h"
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

/// The planes through an edge of one polygon and a corner of the other that have the source on one side and the pass on
/// the other, into `planes`. What can be seen from some point of `source` through `pass` lies in front of all of them.
void find_separators(const Winding& source, const Winding& pass, std::vector<Plane>& planes);

/// Cuts polygons in place; reuses its memory, as visible sets take millions of cuts.
class SightCutter {
  public:
    /// Cuts off what is not in front of the plane; leaves nothing of a polygon on it.
    void cut_to_front(Winding& winding, const Plane& plane);

  private:
    void keep_front(const Winding& winding);

    std::vector<double> heights_;  // 0: on the plane
    Winding kept_;
};

}  // namespace oblong::map
