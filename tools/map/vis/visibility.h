#pragma once

#include <string>
#include <vector>

#include "tools/map/tree/bsp_file.h"
#include "tools/map/tree/model.h"

namespace oblong::map {

/// A set of leaves as in the file: a bit each, leaf 1 first, lowest bit first; a zero byte is followed by the number of
/// zero bytes that it stands for.
std::string packed_row(const std::vector<bool>& leaves);

/// The first `leaf_count` leaves of the row at `offset`; all of them if it is negative.
std::vector<bool> unpacked_row(const std::string& visibility, int offset, std::size_t leaf_count);

/// Gives every leaf of the world the set of leaves that may be seen from it; liquids are seen through. `is_fast`:
/// without cutting lines of sight, so more is thought to be seen.
void add_visibility(BspFile& bsp, const CompiledModel& world, const std::vector<int>& leaf_indices,
                    const PlaneList& planes, bool is_fast);

}  // namespace oblong::map
