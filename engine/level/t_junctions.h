#pragma once

#include <span>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// The vertices inside the edges of a level, ordered by edge, and from its `from` to its `to`: there a corner of one
/// face meets the middle of another face's edge. Rounding to the screen moves the corner off the edge and opens a crack
/// (hard case E9); with the corner inserted into the edge, both faces share all their edges.
std::vector<TJunction> find_t_junctions(const Level& level);

/// Those of one edge.
std::span<const TJunction> junctions_on(std::span<const TJunction> all, EdgeIndex edge);

}  // namespace oblong
