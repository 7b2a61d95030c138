#pragma once

#include <span>

#include "tests/support/point.h"

/// Rays and polygons in doubles.
namespace oblong::test {

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
