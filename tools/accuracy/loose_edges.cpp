#include "tools/accuracy/loose_edges.h"

#include <cmath>
#include <cstdlib>
#include <vector>

namespace oblong {

namespace {

using map::Point;

constexpr double kOnEdge_units = 1.0 / 256;

int start_of(const map::BspFile& bsp, int surf_edge) {
    const auto& ends = bsp.edges[static_cast<std::size_t>(std::abs(surf_edge))];
    return ends[surf_edge < 0 ? 1 : 0];
}

Point place_of(const map::BspFile& bsp, int vertex) {
    return map::to_point(bsp.vertices[static_cast<std::size_t>(vertex)]);
}

/// Whether a corner lies on the line from the one before to the next.
bool is_within_edge(const Point& before, const Point& corner, const Point& next) {
    const Point whole = next - before;
    return map::length(map::cross(whole, corner - before)) <= kOnEdge_units * map::length(whole);
}

std::vector<int> corners_of(const map::BspFile& bsp, const map::FileFace& face) {
    std::vector<int> corners;
    for (int i = 0; i < face.edge_count; ++i)
        corners.push_back(start_of(bsp, bsp.surf_edges[static_cast<std::size_t>(face.first_surf_edge + i)]));
    return corners;
}

std::vector<int> without_those_within_edges(const map::BspFile& bsp, const std::vector<int>& corners) {
    std::vector<int> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const int before = kept.empty() ? corners.back() : kept.back(), next = corners[(i + 1) % corners.size()];
        if (!is_within_edge(place_of(bsp, before), place_of(bsp, corners[i]), place_of(bsp, next)))
            kept.push_back(corners[i]);
    }
    return kept;
}

}  // namespace

void loosen_edges(map::BspFile& bsp) {
    std::vector<std::array<int, 2>> edges{{0, 0}};  // edge 0 has no negative
    std::vector<int> surf_edges;
    for (map::FileFace& face : bsp.faces) {
        const std::vector<int> corners = without_those_within_edges(bsp, corners_of(bsp, face));
        face.first_surf_edge = static_cast<int>(surf_edges.size());
        face.edge_count = static_cast<int>(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            surf_edges.push_back(static_cast<int>(edges.size()));
            edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
        }
    }
    bsp.edges = std::move(edges);
    bsp.surf_edges = std::move(surf_edges);
}

}  // namespace oblong
