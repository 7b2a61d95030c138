#include "tools/map/vis/portal_file.h"

#include <cstdio>

#include "tools/map/vis/visibility.h"

namespace oblong::map {

PortalFile portal_file(const VisGraph& graph) {
    PortalFile file;
    file.count = graph.portals.size() / 2;
    file.text = "PRT1\n" + std::to_string(graph.portals_of_cluster.size()) + "\n" + std::to_string(file.count) + "\n";
    for (std::size_t i = 0; i < graph.portals.size(); i += 2) {  // i + 1 is the way back
        const VisPortal& portal = graph.portals[i];
        file.text += std::to_string(portal.winding.size()) + " " + std::to_string(portal.cluster) + " " +
                     std::to_string(graph.portals[i + 1].cluster);
        for (const Point& point : portal.winding) {
            char text[96];
            std::snprintf(text, sizeof text, " (%.6g %.6g %.6g )", point.x, point.y, point.z);
            file.text += text;
        }
        file.text += "\n";
    }
    return file;
}

}  // namespace oblong::map
