#pragma once

#include "tools/map/vis_portals.h"

namespace oblong::map {

/// Takes out of might_see what lies outside of every view through a portal and one of the next: as the whole flow does,
/// but with the first two portals of a chain only, so that its cost has a bound.
void narrow_might_see(VisGraph& graph);

}  // namespace oblong::map
