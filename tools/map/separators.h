#pragma once

#include "tools/map/winding.h"

namespace oblong::map {

/// What of `target` may be seen from some point of `source` through `pass`: cut by all planes through an edge of the
/// one and a corner of the other that have the source on one side and the pass on the other. Empty: nothing.
Winding seen_through(const Winding& source, const Winding& pass, Winding target);

}  // namespace oblong::map
