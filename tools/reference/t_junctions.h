#pragma once

#include <vector>

#include "tools/reference/vec.h"

namespace oblong::reference {

/// A polygon's corners with the vertices that lie inside its edges, less than 1/512 unit from them, put between. Where
/// that is done to all faces, neighbours meet in the same points: a corner of one in the middle of another's edge,
/// which as a float is never exactly on it, leaves no crack.
class EdgeMender {
  public:
    EdgeMender(const std::vector<Vec>& vertices, const std::vector<int>& used);

    std::vector<int> mended(const std::vector<int>& corners) const;

  private:
    const Vec& at(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)]; }
    std::vector<int> inside(int from, int to) const;

    const std::vector<Vec>& vertices_;
    std::vector<int> by_x_;  ///< the used ones, in the order of x
};

}  // namespace oblong::reference
