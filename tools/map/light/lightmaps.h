#pragma once

#include "tools/map/source/checks.h"
#include "tools/map/source/map_file.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// Gives every lit face a lightmap of direct light: of each source that a sample sees, what arrives at its distance,
/// times (1 + the cosine of the angle of incidence) / 2, halved (so that 255 is twice as bright as a lamp of 255 at
/// no distance). Each light style is a lightmap of its own, at most four for a face: the brightest. A face without
/// light gets none. `is_fast`: one ray a sample and source instead of sixteen. `warnings`, if there are any, name the
/// lamps that stand in walls and light nothing.
void add_light(BspFile& bsp, const std::vector<MapEntity>& entities, bool is_fast, Warnings* warnings);

}  // namespace oblong::map
