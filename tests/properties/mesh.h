#pragma once

#include <array>
#include <cstdint>
#include <ostream>
#include <vector>

#include "engine/view/screen.h"

namespace oblong::test {

/// A rectangle, 1/256 pixel.
struct Rectangle {
    std::int32_t left_8, top_8, right_8, bottom_8;
};

/// How to cut a mesh once more: which triangle and edge, and where.
struct Cut {
    bool is_inside = false;                ///< a new corner inside the triangle, else on (or beside) its edge
    std::uint32_t triangle = 0, edge = 0;  ///< modulo their counts
    std::int64_t weight_a = 1, weight_b = 1, weight_c = 1;
    std::int32_t off_edge_x_8 = 0, off_edge_y_8 = 0;
    std::int32_t grid_8 = 1;  ///< new corners lie on multiples of this: 128 puts many on pixels' centres and borders
};
std::ostream& operator<<(std::ostream& out, const Cut& cut);

/// Triangles that tile a rectangle and meet corner to corner, clockwise as seen. No edge has a corner in its middle.
class Mesh {
  public:
    using Triangle = std::array<ScreenVertex, 3>;

    explicit Mesh(const Rectangle& rectangle);
    /// Cuts; leaves the mesh alone where a new triangle would have no area or be turned over.
    void cut(const Cut& cut);
    const std::vector<Triangle>& triangles() const { return triangles_; }

  private:
    void cut_inside(std::size_t triangle, const ScreenVertex& corner);
    void cut_edge(std::size_t triangle, std::size_t edge, ScreenVertex corner, const Cut& cut);
    void replace(std::vector<std::size_t> old, const std::vector<Triangle>& pieces);

    std::vector<Triangle> triangles_;
};

}  // namespace oblong::test
