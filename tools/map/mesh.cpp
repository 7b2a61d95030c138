#include "tools/map/mesh.h"

#include <algorithm>
#include <cmath>

namespace oblong::map {
namespace {

constexpr double kGrid = 4096;

double snapped(double value) {
    const double whole = std::round(value);
    if (std::abs(value - whole) < 1.0 / 512) return whole;
    return std::round(value * kGrid) / kGrid;
}

}  // namespace

int VertexPool::find_or_add(const Point& point) {
    const Point wanted{snapped(point.x), snapped(point.y), snapped(point.z)};
    int nearest = -1;
    double nearest_distance = kWeldDistance;
    for (const int index : near_box(box_of(std::span(&wanted, 1)).grown(kWeldDistance))) {
        const double distance = length((*this)[index] - wanted);
        if (distance >= nearest_distance) continue;
        nearest = index;
        nearest_distance = distance;
    }
    if (nearest >= 0) return nearest;
    points_.push_back(wanted);
    const int added = static_cast<int>(points_.size()) - 1;
    cells_[cell_of(wanted)].push_back(added);
    return added;
}

std::vector<int> VertexPool::near_box(const Box& box) const {
    std::vector<int> found;
    const Cell low = cell_of(box.mins), high = cell_of(box.maxs);
    for (int x = low[0]; x <= high[0]; ++x) {
        for (int y = low[1]; y <= high[1]; ++y) {
            for (int z = low[2]; z <= high[2]; ++z) {
                const auto cell = cells_.find({x, y, z});
                if (cell != cells_.end()) found.insert(found.end(), cell->second.begin(), cell->second.end());
            }
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

VertexPool::Cell VertexPool::cell_of(const Point& point) {
    const auto cell = [](double value) { return static_cast<int>(std::floor(value / kCell)); };
    return {cell(point.x), cell(point.y), cell(point.z)};
}

}  // namespace oblong::map
