#include <algorithm>

#include "tools/map/vis/sight.h"

namespace oblong::map {
namespace {

// `size_squared`: of the normal, which need not be of length 1.
bool is_off(double scaled_height, double size_squared) {
    return scaled_height * scaled_height > kOnEpsilon * kOnEpsilon * size_squared;
}

// Whether the winding is on the side of a plane through `origin` that `normal` points to, but not all of it on the
// plane.
bool is_in_front(const Winding& winding, const Point& normal, const Point& origin, double size_squared) {
    bool is_off_plane = false;
    for (const Point& point : winding) {
        const double height = dot(normal, point - origin);
        if (!is_off(height, size_squared)) continue;
        if (height < 0) return false;
        is_off_plane = true;
    }
    return is_off_plane;
}

// Appends those through an edge of `a`; they face `b`. All of `a` is on one side of such a plane: that of its middle.
void add_separators_at_edges(const Winding& a, const Winding& b, std::vector<Plane>& planes) {
    const Point middle_of_a = middle(a);
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Point edge = a[(i + 1) % a.size()] - a[i];
        const std::size_t known = planes.size();
        for (const Point& corner : b) {
            if (planes.size() > known && std::abs(planes.back().height_of(corner)) <= kOnEpsilon) continue;
            Point across = cross(edge, corner - a[i]);
            const double size_squared = dot(across, across);
            const double height_of_a = dot(across, middle_of_a - a[i]);
            if (size_squared < kOnEpsilon * kOnEpsilon || !is_off(height_of_a, size_squared)) continue;
            if (height_of_a > 0) across = -across;
            if (!is_in_front(b, across, a[i], size_squared)) continue;
            const Point normal = scaled(across, 1 / std::sqrt(size_squared));
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

void SightCutter::cut_to_front(Winding& winding, const Plane& plane) {
    heights_.clear();
    double highest = 0, lowest = 0;
    for (const Point& point : winding) {
        const double height = plane.height_of(point);
        heights_.push_back(std::abs(height) <= kOnEpsilon ? 0 : height);
        highest = std::max(highest, heights_.back());
        lowest = std::min(lowest, heights_.back());
    }
    if (highest == 0) {
        winding.clear();
    } else if (lowest < 0) {
        keep_front(winding);
        std::swap(winding, kept_);
    }
}

void SightCutter::keep_front(const Winding& winding) {
    kept_.clear();
    for (std::size_t i = 0; i < winding.size(); ++i) {
        const std::size_t next = (i + 1) % winding.size();
        if (heights_[i] >= 0) kept_.push_back(winding[i]);
        if (heights_[i] * heights_[next] >= 0) continue;
        const double part = heights_[i] / (heights_[i] - heights_[next]);
        kept_.push_back(winding[i] + scaled(winding[next] - winding[i], part));
    }
}

}  // namespace oblong::map
