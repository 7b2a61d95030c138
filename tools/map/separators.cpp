#include "tools/map/separators.h"

#include <algorithm>

namespace oblong::map {
namespace {

bool is_in_front(const Winding& winding, const Plane& plane) {
    bool is_off_plane = false;
    for (const Point& point : winding) {
        const double height = plane.height_of(point);
        if (height < -kOnEpsilon) return false;
        is_off_plane = is_off_plane || height > kOnEpsilon;
    }
    return is_off_plane;
}

// Those through an edge of `a`; they face `b`. All of `a` is on one side of such a plane: that of its middle.
std::vector<Plane> separators_at_edges(const Winding& a, const Winding& b) {
    std::vector<Plane> planes;
    const Point middle_of_a = middle(a);
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Point edge = a[(i + 1) % a.size()] - a[i];
        for (const Point& corner : b) {
            const Point across = cross(edge, corner - a[i]);
            const double size = length(across);
            if (size < kOnEpsilon) continue;
            const Point normal = scaled(across, 1 / size);
            Plane plane{normal, dot(normal, a[i])};
            const double height_of_a = plane.height_of(middle_of_a);
            if (std::abs(height_of_a) <= kOnEpsilon) continue;
            if (height_of_a > 0) plane = plane.flipped();
            if (is_in_front(b, plane)) planes.push_back(plane);
        }
    }
    return planes;
}

}  // namespace

std::vector<Plane> separators(const Winding& source, const Winding& pass) {
    std::vector<Plane> planes = separators_at_edges(source, pass);
    for (const Plane& plane : separators_at_edges(pass, source)) planes.push_back(plane.flipped());
    return planes;
}

void cut_to_front(Winding& winding, const Plane& plane) {
    const Reach far = reach(winding, plane);
    if (far.front <= kOnEpsilon) {
        winding.clear();
    } else if (far.back > kOnEpsilon) {
        winding = split(winding, plane).front;
    }
}

}  // namespace oblong::map
