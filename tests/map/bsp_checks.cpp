#include "tests/map/bsp_checks.h"

#include <cmath>
#include <map>

#include "engine/level/level.h"

namespace oblong::test {

using map::BspFile;
using map::cross;
using map::dot;
using map::FileFace;
using map::FilePlane;
using map::Point;
using map::scaled;
using map::to_point;

namespace {

const auto& at(const auto& items, int index) {
    return items.at(static_cast<std::size_t>(index));
}

double height(const FilePlane& plane, const Point& point) {
    return dot(to_point(plane.normal), point) - static_cast<double>(plane.distance);
}

std::array<int, 2> ends_of(const BspFile& bsp, int surf_edge) {
    const auto edge = at(bsp.edges, std::abs(surf_edge));
    return surf_edge < 0 ? std::array{edge[1], edge[0]} : edge;
}

}  // namespace

std::vector<Point> corners_of(const BspFile& bsp, const FileFace& face) {
    std::vector<Point> corners;
    for (int i = 0; i < face.edge_count; ++i)
        corners.push_back(to_point(at(bsp.vertices, ends_of(bsp, at(bsp.surf_edges, face.first_surf_edge + i))[0])));
    return corners;
}

FacingPlane facing_plane(const BspFile& bsp, const FileFace& face) {
    const FilePlane& plane = at(bsp.planes, face.plane);
    const double sign = face.is_back != 0 ? -1 : 1;
    return {scaled(to_point(plane.normal), sign), sign * static_cast<double>(plane.distance)};
}

int leaf_at(const BspFile& bsp, const Point& point) {
    int child = bsp.models.front().head_nodes[0];
    while (child >= 0) {
        const auto& node = at(bsp.nodes, child);
        child = node.children[height(at(bsp.planes, node.plane), point) < 0 ? 1 : 0];
    }
    return -1 - child;
}

int contents_at(const BspFile& bsp, int model, int hull, const Point& point) {
    int child = at(bsp.models, model).head_nodes[static_cast<std::size_t>(hull)];
    while (child >= 0) {
        const int plane = hull == 0 ? at(bsp.nodes, child).plane : at(bsp.clip_nodes, child).plane;
        const auto& children = hull == 0 ? at(bsp.nodes, child).children : at(bsp.clip_nodes, child).children;
        child = children[height(at(bsp.planes, plane), point) < 0 ? 1 : 0];
    }
    return hull == 0 ? at(bsp.leaves, -1 - child).contents : child;
}

int open_edges(const BspFile& bsp) {
    std::map<std::array<int, 2>, int> uses;
    const auto& world = bsp.models.front();
    for (int i = 0; i < world.face_count; ++i) {
        const FileFace& face = at(bsp.faces, world.first_face + i);
        for (int k = 0; k < face.edge_count; ++k) {
            const auto ends = ends_of(bsp, at(bsp.surf_edges, face.first_surf_edge + k));
            ++uses[ends];
            --uses[{ends[1], ends[0]}];
        }
    }
    int open = 0;
    for (const auto& [ends, count] : uses) open += count > 0 ? count : 0;
    return open;
}

std::vector<bool> visible_leaves(const BspFile& bsp, int leaf) {
    const int count = bsp.models.front().visible_leaf_count;
    std::vector<bool> seen(static_cast<std::size_t>(count) + 1, false);
    int offset = at(bsp.leaves, leaf).visibility_offset;
    for (int byte = 0; byte < (count + 7) / 8;) {
        const int value = static_cast<unsigned char>(bsp.visibility.at(static_cast<std::size_t>(offset++)));
        if (value == 0) {
            byte += static_cast<unsigned char>(bsp.visibility.at(static_cast<std::size_t>(offset++)));
            continue;
        }
        for (int bit = 0; bit < 8; ++bit) {
            if ((value >> bit & 1) != 0) seen.at(static_cast<std::size_t>(8 * byte + bit + 1)) = true;
        }
        ++byte;
    }
    return seen;
}

}  // namespace oblong::test
