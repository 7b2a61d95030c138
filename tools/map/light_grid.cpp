#include "tools/map/light_grid.h"

#include <algorithm>
#include <cmath>

namespace oblong::map {
namespace {

double texel_at(const std::array<float, 4>& axis, const std::array<float, 3>& point) {
    double texel = axis[3];
    for (std::size_t i = 0; i < 3; ++i) texel += static_cast<double>(axis[i]) * static_cast<double>(point[i]);
    return texel;
}

}  // namespace

std::vector<std::array<float, 3>> face_corners(const BspFile& bsp, const FileFace& face) {
    std::vector<std::array<float, 3>> corners;
    for (int i = 0; i < face.edge_count; ++i) {
        const int edge = bsp.surf_edges[static_cast<std::size_t>(face.first_surf_edge + i)];
        const auto& ends = bsp.edges[static_cast<std::size_t>(std::abs(edge))];
        corners.push_back(bsp.vertices[static_cast<std::size_t>(ends[edge < 0 ? 1 : 0])]);
    }
    return corners;
}

LightGrid light_grid(const BspFile& bsp, const FileFace& face) {
    const auto corners = face_corners(bsp, face);
    const FileTexInfo& texinfo = bsp.texinfos[static_cast<std::size_t>(face.texinfo)];
    LightGrid grid;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        double low = texel_at(texinfo.axes[axis], corners[0]), high = low;
        for (const auto& corner : corners) {
            low = std::min(low, texel_at(texinfo.axes[axis], corner));
            high = std::max(high, texel_at(texinfo.axes[axis], corner));
        }
        grid.first[axis] = static_cast<int>(std::floor(low / LightGrid::kStep));
        grid.count[axis] = static_cast<int>(std::ceil(high / LightGrid::kStep)) - grid.first[axis] + 1;
    }
    return grid;
}

}  // namespace oblong::map
