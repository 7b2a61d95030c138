#pragma once

#include "tools/map/winding.h"

namespace oblong::map {

/// The planes through an edge of one polygon and a corner of the other that have the source on one side and the pass on
/// the other. What can be seen from some point of `source` through `pass` lies in front of all of them.
std::vector<Plane> separators(const Winding& source, const Winding& pass);

/// Cuts off what is not in front of the plane; leaves nothing of a polygon on it.
void cut_to_front(Winding& winding, const Plane& plane);

}  // namespace oblong::map
