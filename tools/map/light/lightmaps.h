#pragma once

#include <vector>

#include "tools/map/source/checks.h"
#include "tools/map/source/map_file.h"
#include "tools/map/tree/bsp_file.h"
#include "tools/map/work_sharing.h"

namespace oblong {
struct Palette;
}

namespace oblong::map {

struct LightOptions {
    bool is_fast = false;     ///< one ray a sample and source instead of sixteen, and fewer rays of the hemisphere
    bool has_dirt = false;    ///< as worldspawn's _dirt 1
    bool has_bounce = false;  ///< as its _bounce 1, unless it says more
    const Palette* palette = nullptr;    ///< for the brightness of textures in bounces; null: all half
    std::vector<SurfaceLight> surfaces;  ///< by texinfo
};

/// Gives every lit face a lightmap of direct light: for each source visible from a sample, its light at that distance
/// times (1 + the cosine of the angle of incidence) / 2, halved (so that 255 is twice as bright as a lamp of 255 at
/// distance 0). Each light style has its own lightmap; a face keeps the four brightest. A face without light gets none.
/// If worldspawn or the options require it, adds light from the hemisphere over a sample, from sky and from other faces
/// of the world, and reduces direct light in corners. Warns of lamps that light nothing.
void add_light(BspFile& bsp, const std::vector<MapEntity>& entities, const LightOptions& options, Warnings& warnings,
               const WorkSharing& sharing);

}  // namespace oblong::map
