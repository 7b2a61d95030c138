#pragma once

#include <vector>

#include "engine/surface/palette.h"
#include "tools/accuracy/measured_level.h"

namespace oblong {

/// Small levels compiled at run time, each hard for approximations, in the demo level's colours: a wall with depths of
/// 1:10 and 1:1000 across the screen, a wall close by, a floor to the horizon, a tilted plane, slivers, a tower far
/// away, a sphere of many facets from several sides. At most `most_cameras` of each.
std::vector<MeasuredLevel> make_hard_scenes(const Palette& palette, std::size_t most_cameras);

}  // namespace oblong
