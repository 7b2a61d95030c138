#include "tests/support/reference_polygons.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace oblong::reference {

namespace {

/// Above 0 to the right of the edge's direction (y down), 0 on it.
std::int64_t edge_function(const GridPoint& from, const GridPoint& to, const GridPoint& p) {
    return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
}

/// For an edge of a clockwise triangle.
bool is_top_or_left(const GridPoint& from, const GridPoint& to) {
    const bool is_top = from.y == to.y && to.x > from.x;
    const bool is_left = to.y < from.y;
    return is_top || is_left;
}

/// normal . p >= offset is inside.
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

}  // namespace

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

bool covers(const std::array<GridPoint, 3>& corners, std::int32_t column, std::int32_t row) {
    std::array<GridPoint, 3> clockwise = corners;
    const std::int64_t area = edge_function(corners[0], corners[1], corners[2]);
    if (area == 0) return false;
    if (area < 0) std::swap(clockwise[1], clockwise[2]);
    const GridPoint centre{column * std::int64_t{256} + 128, row * std::int64_t{256} + 128};
    for (std::size_t i = 0; i < 3; ++i) {
        const GridPoint &from = clockwise[i], &to = clockwise[(i + 1) % 3];
        const std::int64_t side = edge_function(from, to, centre);
        if (side < 0 || (side == 0 && !is_top_or_left(from, to))) return false;
    }
    return true;
}

void add_triangle(const std::array<GridPoint, 3>& corners, CoverageMap& map) {
    for (std::int32_t row = 0; row < map.height_px; ++row)
        for (std::int32_t column = 0; column < map.width_px; ++column)
            map.at(column, row) += covers(corners, column, row);
}

std::string picture_of_difference(const CoverageMap& expected, const CoverageMap& found) {
    const auto different = std::mismatch(expected.counts.begin(), expected.counts.end(), found.counts.begin());
    if (different.first == expected.counts.end()) return "";
    const auto index = static_cast<std::int32_t>(different.first - expected.counts.begin());
    const std::int32_t left = std::max(index % expected.width_px - 30, 0), top = index / expected.width_px;
    std::string text = "from column " + std::to_string(left) + ", row " + std::to_string(top) + "\n";
    for (std::int32_t row = top; row < std::min(top + 20, expected.height_px); ++row, text += '\n')
        for (std::int32_t column = left; column < std::min(left + 60, expected.width_px); ++column) {
            const auto at = static_cast<std::size_t>(row * expected.width_px + column);
            const std::int32_t missing = expected.counts[at] - found.counts[at];
            text += missing > 0 ? '|' : missing < 0 ? '-' : expected.counts[at] > 0 ? '+' : '.';
        }
    return text;
}

Texel texel_at(const std::array<TexturedCorner, 3>& corners, const Projection& projection, ScreenPoint at) {
    const Vec ray{(at.x - projection.width_px / 2) / projection.multiplier_x,
                  (projection.height_px / 2 - at.y) / projection.multiplier_y, 1};
    const Vec &a = corners[0].position, &b = corners[1].position, &c = corners[2].position;
    const double weights[] = {dot(cross(b, c), ray), dot(cross(c, a), ray), dot(cross(a, b), ray)};
    const double sum = weights[0] + weights[1] + weights[2];
    Texel texel{0, 0, sum / dot(a, cross(b, c))};
    for (std::size_t i = 0; i < 3; ++i) {
        texel.u += weights[i] * corners[i].u / sum;
        texel.v += weights[i] * corners[i].v / sum;
    }
    return texel;
}

}  // namespace oblong::reference
