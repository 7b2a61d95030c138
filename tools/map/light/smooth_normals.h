#pragma once

#include <vector>

#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// The normals at each face's corners for light (the faces stay flat). If a face's texinfo has an angle above 0 in
/// `degrees`, a corner's normal is the mean of the normals of all such faces at this corner, weighted by their angles
/// there, except those that differ from this face's by more than the smaller of both faces' limits. Empty for all other
/// faces.
std::vector<std::vector<Point>> smooth_normals(const BspFile& bsp, const std::vector<double>& degrees);

}  // namespace oblong::map
