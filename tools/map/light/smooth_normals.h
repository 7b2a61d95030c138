#pragma once

#include <vector>

#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// The normal at each corner of each face, for light (the faces stay flat). Where a face's texinfo has an angle above 0
/// in `degrees`, a corner's is the mean of the normals of all such faces that meet there, weighted by their angles
/// there, of which each leans from this face's by no more than the smaller of both angles. Empty for all other faces.
std::vector<std::vector<Point>> smooth_normals(const BspFile& bsp, const std::vector<double>& degrees);

}  // namespace oblong::map
