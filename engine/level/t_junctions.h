#pragma once

#include <span>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// The vertices inside each edge of a level, in order from `from` to `to`: there a corner of one face meets the middle
/// of another face's edge. Rounding to the screen moves the corner off the edge and opens a crack (hard case E9); with
/// the corner inserted into the edge, both faces share all their edges.
class TJunctions {
  public:
    explicit TJunctions(const Level& level);

    std::span<const VertexIndex> on_edge(EdgeIndex edge) const {
        return std::span(vertices_).subspan(found_[edge].first, found_[edge].count);
    }

  private:
    struct Found {
        std::size_t first = 0, count = 0;  ///< in vertices_
    };

    Table<Found, Edge> found_;
    std::vector<VertexIndex> vertices_;
};

}  // namespace oblong
