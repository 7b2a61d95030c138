#pragma once

#include "tools/map/bsp_file.h"
#include "tools/map/map_parse.h"

namespace oblong::map {

/// Gives every lit face a lightmap.
void add_light(BspFile& bsp, const std::vector<MapEntity>& entities, bool is_fast);

}  // namespace oblong::map
