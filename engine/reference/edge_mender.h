#pragma once

#include <vector>

#include "engine/reference/vec.h"

namespace oblong::reference {

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
