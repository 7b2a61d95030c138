#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace oblong::reference {

/// A corner in 1/256 pixel; |coordinates| up to 2^28.
struct GridPoint {
    std::int64_t x = 0, y = 0;
};

/// Whether a triangle, of either winding, covers the pixel's centre: strictly inside, on a top edge (exactly
/// horizontal, the triangle below it) or on a left edge (not horizontal, the triangle to its right). By edge functions,
/// in exact integers.
bool covers(const std::array<GridPoint, 3>& corners, std::int32_t column, std::int32_t row);

/// A raster of covered pixels: counts, row after row.
struct CoverageMap {
    std::int32_t width_px = 320, height_px = 200;
    std::vector<std::int32_t> counts = std::vector<std::int32_t>(64000);

    std::int32_t& at(std::int32_t column, std::int32_t row) {
        return counts[static_cast<std::size_t>(row * width_px + column)];
    }
};

void add_triangle(const std::array<GridPoint, 3>& corners, CoverageMap& map);

/// Where two maps differ, as text: + in both, | missing, - too much, . in none. Empty where they are equal; around the
/// first difference, 60 columns by 20 rows.
std::string picture_of_difference(const CoverageMap& expected, const CoverageMap& found);

}  // namespace oblong::reference
