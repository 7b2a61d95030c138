#include "tools/map/vis/portal_file.h"

#include <charconv>
#include <iterator>

#include "tools/map/vis/visibility.h"

namespace oblong::map {

namespace {

// With six digits, and a space.
void add_number(std::string& text, double number) {
    char digits[32];
    text.append(digits, std::to_chars(std::begin(digits), std::end(digits), number, std::chars_format::general, 6).ptr);
    text += ' ';
}

}  // namespace

void describe_portals(const VisGraph& graph, PortalFile& file) {
    file.count = graph.portals.size() / 2;
    if (!file.has_text) return;
    file.text = "PRT1\n" + std::to_string(graph.portals_of_cluster.size()) + "\n" + std::to_string(file.count) + "\n";
    for (std::size_t i = 0; i < graph.portals.size(); i += 2) {  // i + 1 is the way back
        const VisPortal& portal = graph.portals[i];
        file.text += std::to_string(portal.winding.size()) + " " + std::to_string(portal.cluster) + " " +
                     std::to_string(graph.portals[i + 1].cluster);
        for (const Point& point : portal.winding) {
            file.text += " (";
            for (int axis = 0; axis < 3; ++axis) add_number(file.text, point[axis]);
            file.text += ")";
        }
        file.text += "\n";
    }
}

}  // namespace oblong::map
