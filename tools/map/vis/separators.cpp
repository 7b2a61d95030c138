#include <algorithm>

#include "tools/map/vis/visibility.h"

namespace oblong::map {

namespace {

// Smaller heights are rounding errors.
constexpr double kNoHeight = 1e-8;

// A plane through an edge, with a normal of any length, and a point of the edge.
struct EdgePlane {
    Point normal, origin;
    double on_squared = 0;  // the square of the scaled height beyond which a point is off the plane

    EdgePlane(const Point& across, const Point& through)
        : normal(across), origin(through), on_squared(kOnEpsilon * kOnEpsilon * dot(across, across)) {}

    // The square of a scaled height, with the height's sign.
    double signed_square_of(const Point& point) const {
        const double height = dot(normal, point - origin);
        return height * std::abs(height);
    }
};

// Whether the winding is in front of the plane, and not completely on it. Checks the neighbours of `corner`, which is
// on the plane, first: if they are in front, all corners nearly always are.
bool is_in_front(const Winding& winding, std::size_t corner, const EdgePlane& plane) {
    const std::size_t last = winding.size() - 1;
    const double after = plane.signed_square_of(winding[corner == last ? 0 : corner + 1]);
    const double before = plane.signed_square_of(winding[corner == 0 ? last : corner - 1]);
    if (std::min(before, after) < -plane.on_squared) return false;
    double highest = 0, lowest = 0;
    for (const Point& point : winding) {
        const double square = plane.signed_square_of(point);
        highest = std::max(highest, square);
        lowest = std::min(lowest, square);
    }
    return lowest >= -plane.on_squared && highest > plane.on_squared;
}

// Appends the separators through an edge of `a`; they face `b`. All of `a` is on one side of such a plane: that of its
// middle. An edge in one of the existing planes needs none.
void add_separators_at_edges(const Winding& a, const Winding& b, std::vector<Plane>& planes) {
    const Point middle_of_a = middle(a);
    const auto there = static_cast<std::ptrdiff_t>(planes.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Point& end = a[i + 1 == a.size() ? 0 : i + 1];
        if (std::any_of(planes.begin(), planes.begin() + there, [&](const Plane& plane) {
                return std::abs(plane.height_of(a[i])) < kNoHeight && std::abs(plane.height_of(end)) < kNoHeight;
            }))
            continue;
        const Point edge = end - a[i];
        const Point to_middle = middle_of_a - a[i];
        const std::size_t known = planes.size();
        for (std::size_t corner = 0; corner < b.size(); ++corner) {
            if (planes.size() > known && std::abs(planes.back().height_of(b[corner])) <= kOnEpsilon) continue;
            const Point across = cross(edge, b[corner] - a[i]);
            const double size_squared = dot(across, across);
            const double height_of_a = dot(across, to_middle);
            const EdgePlane plane(across * std::copysign(1.0, -height_of_a),
                                  a[i]);  // without a branch, as half of them are flipped
            if (size_squared < kOnEpsilon * kOnEpsilon || height_of_a * height_of_a <= plane.on_squared) continue;
            if (!is_in_front(b, corner, plane)) continue;
            const Point normal = plane.normal * (1 / std::sqrt(size_squared));
            planes.push_back({normal, dot(normal, a[i])});
        }
    }
}

}  // namespace

void find_separators(const Winding& source, const Winding& pass, std::vector<Plane>& planes) {
    planes.clear();
    add_separators_at_edges(pass, source, planes);
    for (Plane& plane : planes) plane = plane.flipped();
    add_separators_at_edges(source, pass, planes);
}

}  // namespace oblong::map
