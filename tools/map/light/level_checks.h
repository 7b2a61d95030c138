#pragma once

#include <vector>

#include "tools/map/source/checks.h"
#include "tools/map/source/textures.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// What is odd about a level that is compiled, each with a line of its source: textures that nothing shows, surfaces
/// and lists that are too large, and textures that lie so that much of the light is for nothing. `names` are those of
/// the level's first textures.
void find_level_warnings(const BspFile& bsp, const std::vector<MapEntity>& entities,
                         const std::vector<TextureUse>& names, Warnings& warnings);

/// WADs from which no texture of these names comes.
void find_unused_wads(const std::vector<Wad>& wads, const std::vector<TextureUse>& names, Warnings& warnings);

}  // namespace oblong::map
