#include "tools/map/winding.h"

#include <algorithm>

namespace oblong::map {
namespace {

std::vector<double> heights_over(const Winding& winding, const Plane& plane) {
    std::vector<double> heights;
    heights.reserve(winding.size());
    for (const Point& point : winding) {
        const double height = plane.height_of(point);
        heights.push_back(std::abs(height) <= kOnEpsilon ? 0 : height);
    }
    return heights;
}

// Always from the point in front to the one behind.
Point crossing(const Point& front, double front_height, const Point& back, double back_height, const Plane& plane) {
    Point at = front + scaled(back - front, front_height / (front_height - back_height));
    for (int axis = 0; axis < 3; ++axis) {
        const double facing = component(plane.normal, axis);
        if (facing == 1.0 || facing == -1.0) component(at, axis) = facing * plane.distance;
    }
    return at;
}

void add_crossing(SplitWinding& parts, const Point& a, double a_height, const Point& b, double b_height,
                  const Plane& plane) {
    if (a_height * b_height >= 0) return;
    const Point at =
        a_height > 0 ? crossing(a, a_height, b, b_height, plane) : crossing(b, b_height, a, a_height, plane);
    parts.front.push_back(at);
    parts.back.push_back(at);
}

SplitWinding cut(const Winding& winding, const Plane& plane, const std::vector<double>& heights) {
    SplitWinding parts;
    for (std::size_t i = 0; i < winding.size(); ++i) {
        const std::size_t next = (i + 1) % winding.size();
        if (heights[i] >= 0) parts.front.push_back(winding[i]);
        if (heights[i] <= 0) parts.back.push_back(winding[i]);
        add_crossing(parts, winding[i], heights[i], winding[next], heights[next], plane);
    }
    return parts;
}

}  // namespace

Winding whole_plane(const Plane& plane) {
    const int type = plane_type(plane);
    const bool is_level = type == 2 || type == 5;
    const Point rough_up = axis_vector(is_level ? 0 : 2);
    Point up = rough_up - scaled(plane.normal, dot(rough_up, plane.normal));
    up = scaled(up, kHuge / length(up));
    const Point right = cross(up, plane.normal);
    const Point centre = scaled(plane.normal, plane.distance);
    return {centre - right + up, centre + right + up, centre + right - up, centre - right - up};
}

SplitWinding split(const Winding& winding, const Plane& plane) {
    const std::vector<double> heights = heights_over(winding, plane);
    const bool has_front = std::any_of(heights.begin(), heights.end(), [](double height) { return height > 0; });
    const bool has_back = std::any_of(heights.begin(), heights.end(), [](double height) { return height < 0; });
    if (!has_front && !has_back) return {{}, {}, true};
    if (!has_back) return {winding, {}, false};
    if (!has_front) return {{}, winding, false};
    return cut(winding, plane, heights);
}

Winding clipped_to_front(const Winding& winding, const Plane& plane) {
    SplitWinding parts = split(winding, plane);
    return parts.is_on ? winding : std::move(parts.front);
}

Reach reach(const Winding& winding, const Plane& plane) {
    Reach result;
    for (const Point& point : winding) {
        const double height = plane.height_of(point);
        result.front = std::max(result.front, height);
        result.back = std::max(result.back, -height);
    }
    return result;
}

Winding reversed(const Winding& winding) {
    return {winding.rbegin(), winding.rend()};
}

Point area_vector(const Winding& winding) {
    Point sum;
    for (std::size_t i = 2; i < winding.size(); ++i)
        sum = sum + cross(winding[i - 1] - winding[0], winding[i] - winding[0]);
    return sum;
}

double least_width(const Winding& winding) {
    double least = 2 * kHuge;
    for (std::size_t i = 0; i < winding.size(); ++i) {
        const Point edge = winding[(i + 1) % winding.size()] - winding[i];
        const double size = length(edge);
        if (size <= kOnEpsilon) continue;
        double farthest = 0;
        for (const Point& point : winding)
            farthest = std::max(farthest, length(cross(edge, point - winding[i])) / size);
        least = std::min(least, farthest);
    }
    return least;
}

Point middle(const Winding& winding) {
    Point sum;
    for (const Point& point : winding) sum = sum + point;
    return scaled(sum, 1.0 / static_cast<double>(winding.size()));
}

}  // namespace oblong::map
