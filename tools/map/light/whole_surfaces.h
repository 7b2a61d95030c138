#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// The name of a face's texture, in lower case.
std::string texture_name(const BspFile& bsp, const FileFace& face);

/// The groups of meant faces (as indices) that the compiler cut from one surface: they have the same plane, facing and
/// texture alignment, and share edges. In the order of their first faces.
std::vector<std::vector<int>> whole_surfaces(const BspFile& bsp, const std::function<bool(const FileFace&)>& is_meant);

}  // namespace oblong::map
