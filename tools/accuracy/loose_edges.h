#pragma once

#include "tools/map/tree/bsp_file.h"

namespace oblong {

/// Takes from every face the corners that lie within its edges, which the compiler put where corners of other faces
/// touch: the level as a compiler without that step writes it, with T-junctions for the engine to mend.
void loosen_edges(map::BspFile& bsp);

}  // namespace oblong
