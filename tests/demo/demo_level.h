#pragma once

#include <algorithm>
#include <vector>

#include "game/simulation/demo.h"
#include "tests/support/levels.h"

namespace oblong::test {

inline Demo recorded_walk() {
    return decode_demo(read_file_bytes(build_folder() + "/assets/walk.demo"));
}

inline std::vector<Point> corners_of(const Level& level, const Face& face) {
    std::vector<Point> corners;
    for (const SurfEdge edge : level.edges_of(face)) corners.push_back(to_point(level.vertices[level.start_of(edge)]));
    return corners;
}

/// The lowest and the highest coordinates of points.
struct Extent {
    Point low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};

    void add(const Point& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
};

}  // namespace oblong::test
