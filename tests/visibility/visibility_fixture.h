#pragma once

#include <vector>

#include "engine/scene/face_table.h"
#include "engine/scene/placed_models.h"
#include "tests/support/levels.h"
#include "tests/support/random.h"
#include "tests/support/views.h"

namespace oblong::test {

inline std::vector<Point> points_of(const Level& level, std::span<const VertexIndex> vertices, Vec3<World> offset) {
    std::vector<Point> points;
    for (const VertexIndex vertex : vertices) points.push_back(to_point(level.vertices[vertex] + offset));
    return points;
}
inline LevelBox random_box(std::mt19937& random, std::int32_t reach, std::int32_t largest) {
    LevelBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.mins[axis] = random_below(random, 2 * reach) - reach;
        box.maxs[axis] = std::min(box.mins[axis] + random_below(random, largest), reach);
    }
    return box;
}

}  // namespace oblong::test
