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
    bool is_fast = false;              ///< one ray a sample and source instead of sixteen, and fewer of the hemisphere
    bool has_dirt = false;             ///< as worldspawn's _dirt 1
    bool has_bounce = false;           ///< as its _bounce 1, unless it says more
    Warnings* warnings = nullptr;      ///< of lamps that stand in walls and light nothing, if not null
    const Palette* palette = nullptr;  ///< how bright textures are, for bounces; null: all half
    std::vector<double> smooth_degrees;  ///< by texinfo: see smooth_normals()
};

/// Gives every lit face a lightmap of direct light: of each source that a sample sees, what arrives at its distance,
/// times (1 + the cosine of the angle of incidence) / 2, halved (so that 255 is twice as bright as a lamp of 255 at
/// no distance). Each light style is a lightmap of its own, at most four for a face: the brightest. A face without
/// light gets none. To that comes, if worldspawn or the options ask for it, what arrives from the hemisphere over a
/// sample: from sky, and from other faces of the world; and less of the direct light arrives in corners.
void add_light(BspFile& bsp, const std::vector<MapEntity>& entities, const LightOptions& options,
               const WorkSharing& sharing);

}  // namespace oblong::map
