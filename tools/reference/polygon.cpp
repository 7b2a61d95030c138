#include "tools/reference/polygon.h"

#include <cmath>

namespace oblong::reference {

std::vector<Vec> clip(const std::vector<Vec>& polygon, const Plane& plane) {
    std::vector<Vec> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double from_distance = dot(plane.normal, from) - plane.offset;
        const double to_distance = dot(plane.normal, to) - plane.offset;
        if (from_distance >= 0) result.push_back(from);
        if ((from_distance > 0 && to_distance < 0) || (from_distance < 0 && to_distance > 0))
            result.push_back(from + (to - from) * (from_distance / (from_distance - to_distance)));
    }
    return result;
}

std::vector<Vec> clip_to_view(std::vector<Vec> polygon, double near, double far, const Projection& projection) {
    const double side = projection.width_px / 2 / projection.multiplier_x,
                 top = projection.height_px / 2 / projection.multiplier_y;
    const Plane planes[] = {{{0, 0, 1}, near},  {{0, 0, -1}, -far}, {{1, 0, side}, 0},
                            {{-1, 0, side}, 0}, {{0, 1, top}, 0},   {{0, -1, top}, 0}};
    for (const Plane& plane : planes) polygon = clip(polygon, plane);
    return polygon;
}

double area(const std::vector<ScreenPoint>& polygon) {
    double doubled = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ScreenPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        doubled += a.x * b.y - b.x * a.y;
    }
    return std::abs(doubled) / 2;
}

double visible_area(const std::vector<Vec>& polygon, double near, double far, const Projection& projection) {
    std::vector<ScreenPoint> screen;
    for (const Vec& corner : clip_to_view(polygon, near, far, projection))
        screen.push_back(project(corner, projection));
    return area(screen);
}

}  // namespace oblong::reference
