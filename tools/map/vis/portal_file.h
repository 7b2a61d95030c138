#pragma once

#include <string>

namespace oblong::map {

struct VisGraph;

/// The portals between clusters of leaves, for editors.
struct PortalFile {
    bool has_text = true;  ///< set before: whether the text is required
    std::size_t count = 0;
    std::string text;  ///< of a .prt file: "PRT1", the number of clusters and of portals, then a line a portal: number
                       ///< of points, the cluster that sees them run clockwise, the other one, and the points
};

/// Sets the count, and the text if required.
void describe_portals(const VisGraph& graph, PortalFile& file);

}  // namespace oblong::map
