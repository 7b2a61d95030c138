#include "tools/map/light.h"

#include "tools/map/light_grid.h"

namespace oblong::map {

void add_light(BspFile& bsp, const std::vector<MapEntity>&, bool) {
    for (FileFace& face : bsp.faces) {
        if (bsp.texinfos[static_cast<std::size_t>(face.texinfo)].flags != 0) continue;
        face.light_offset = static_cast<int>(bsp.lighting.size());
        face.styles[0] = 0;
        bsp.lighting.append(static_cast<std::size_t>(light_grid(bsp, face).size()), static_cast<char>(160));
    }
}

}  // namespace oblong::map
