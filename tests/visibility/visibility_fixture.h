#pragma once

/// Rays and polygons in doubles.
#include <span>
#include <vector>

#include "engine/scene/face_table.h"
#include "engine/scene/placed_models.h"
#include "tests/support/levels.h"
#include "tests/support/point.h"
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

/// Twice a polygon's area, along its normal.
inline Point doubled_area(std::span<const Point> corners) {
    Point sum;
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum = sum + cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return sum;
}

/// How a ray and a convex polygon meet. Doubtful: near an edge of it, or nearly in its plane.
enum class Meeting { Miss, Hit, Doubtful };

struct Passage {
    Meeting meeting = Meeting::Miss;
    double along = 0;            ///< of a hit: in lengths of the ray
    bool is_from_front = false;  ///< of a hit: corners run clockwise seen from the eye
};

inline Passage pass_through(std::span<const Point> corners, Point eye, Point ray) {
    int sides[3] = {0, 0, 0};  // edges that the ray passes to the left of, close by, to the right of
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point from = corners[i] - eye, to = corners[(i + 1) % corners.size()] - eye;
        const Point across = cross(from, to);
        const double distance = dot(across, ray) / (length(across) * length(ray) + 1e-30);
        ++sides[distance > 1e-4 ? 2 : distance < -1e-4 ? 0 : 1];
    }
    if (sides[0] && sides[2]) return {};
    const Point normal = doubled_area(corners);
    const double along = dot(normal, corners[0] - eye) / dot(normal, ray);
    if (along < 0) return {};
    return {sides[1] ? Meeting::Doubtful : Meeting::Hit, along, dot(normal, ray) > 0};
}

}  // namespace oblong::test
