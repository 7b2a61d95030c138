#include "tools/reference/coverage.h"

#include <algorithm>
#include <utility>

namespace oblong::reference {

namespace {

/// Above 0 right of the edge as one walks it (y down), 0 on it.
std::int64_t edge_function(const GridPoint& from, const GridPoint& to, const GridPoint& p) {
    return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
}

/// Of an edge of a triangle that runs clockwise.
bool is_top_or_left(const GridPoint& from, const GridPoint& to) {
    const bool is_top = from.y == to.y && to.x > from.x;
    const bool is_left = to.y < from.y;
    return is_top || is_left;
}

}  // namespace

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

}  // namespace oblong::reference
