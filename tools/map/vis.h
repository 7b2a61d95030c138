#pragma once

#include "tools/map/bsp_file.h"
#include "tools/map/model.h"

namespace oblong::map {

/// Gives every leaf of the world the set of leaves that may be seen from it; liquids are seen through. `is_fast`:
/// without cutting lines of sight, so more is thought to be seen.
void add_visibility(BspFile& bsp, const CompiledModel& world, const std::vector<int>& leaf_indices,
                    const PlaneList& planes, bool is_fast);

}  // namespace oblong::map
