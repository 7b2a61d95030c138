#pragma once

#include "tools/map/winding.h"

namespace oblong::map {

/// Joins convex polygons of one plane and one facing that share a whole edge, where the union is convex.
std::vector<Winding> merged(std::vector<Winding> windings);

}  // namespace oblong::map
