#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// The name of a face's texture, in lower case.
std::string texture_name(const BspFile& bsp, const FileFace& face);

/// Of the faces that are meant, those together (as indices) that the compiler cut from one surface: they have the
/// plane, the facing and the way that the texture lies in common, and go on from edge to edge. In the order of their
/// first faces.
std::vector<std::vector<int>> whole_surfaces(const BspFile& bsp, const std::function<bool(const FileFace&)>& is_meant);

}  // namespace oblong::map
