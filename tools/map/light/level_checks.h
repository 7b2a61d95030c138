#pragma once

#include <vector>

#include "tools/map/source/checks.h"
#include "tools/map/source/textures.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// Warns of oddities of a compiled level, each with its source line: textures that are on no visible face, too large
/// surfaces and lists, and textures whose alignment wastes light samples. `names` are those of the level's first
/// textures.
void find_level_warnings(const BspFile& bsp, const std::vector<MapEntity>& entities,
                         const std::vector<TextureUse>& names, Warnings& warnings);

/// Warns of WADs that provide none of these textures.
void find_unused_wads(const std::vector<Wad>& wads, const std::vector<TextureUse>& names, Warnings& warnings);

}  // namespace oblong::map
