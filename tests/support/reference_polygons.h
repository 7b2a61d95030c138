#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/reference/view.h"

/// Polygons and triangles in doubles or in exact integers: what only tests need besides engine/reference.
namespace oblong::reference {

/// The part of a convex polygon in viewspace between two depths and the four sides of the view.
std::vector<Vec> clip_to_view(std::vector<Vec> polygon, double near, double far, const Projection& projection);

/// The area of a polygon on the screen, square pixels.
double area(const std::vector<ScreenPoint>& polygon);

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

/// The difference of two maps as text: + in both, | missing, - extra, . in neither. Empty if they are equal; around the
/// first difference, 60 columns by 20 rows.
std::string picture_of_difference(const CoverageMap& expected, const CoverageMap& found);

struct TexturedCorner {
    Vec position;
    double u = 0, v = 0;
};

/// The texel of a triangle's plane at a screen position, by barycentric weights of the ray through it.
Texel texel_at(const std::array<TexturedCorner, 3>& corners, const Projection& projection, ScreenPoint at);

}  // namespace oblong::reference
