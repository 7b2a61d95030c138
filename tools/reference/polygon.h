#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/reference/vec.h"
#include "tools/reference/view.h"

namespace oblong::reference {

/// normal . p >= offset is inside.
struct Plane {
    Vec normal;
    double offset = 0;
};

std::vector<Vec> clip(const std::vector<Vec>& polygon, const Plane& plane);

/// The part of a convex polygon in viewspace between two depths and the four sides of the view.
std::vector<Vec> clip_to_view(std::vector<Vec> polygon, double near, double far, const Projection& projection);

/// The area of a polygon on the screen, square pixels.
double area(const std::vector<ScreenPoint>& polygon);

/// The same after clipping.
double visible_area(const std::vector<Vec>& polygon, double near, double far, const Projection& projection);

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

/// Inserts into a polygon's edges the vertices that are within 1/512 unit of them. If this is done for all faces,
/// neighbours meet in the same points: a corner in the middle of another face's edge, which as a float is never exactly
/// on it, leaves no crack.
class EdgeMender {
  public:
    EdgeMender(const std::vector<Vec>& vertices, const std::vector<int>& used);

    std::vector<int> mended(const std::vector<int>& corners) const;

  private:
    const Vec& at(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)]; }
    std::vector<int> inside(int from, int to) const;

    const std::vector<Vec>& vertices_;
    std::vector<int> by_x_;  ///< the used ones, sorted by x
};

}  // namespace oblong::reference
