#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// The vertices that lie in the interior of each of a level's edges, from its `from` end to its `to` end: where a
/// corner of one face meets the middle of another's edge. Rounded to the screen, the corner leaves the edge by part of
/// a pixel and opens a crack (hard case E9); with the corner made part of the edge, both faces have the same outline.
class TJunctions {
  public:
    explicit TJunctions(const Level& level);

    std::span<const std::int32_t> on_edge(std::int32_t edge) const {
        const auto first = first_[static_cast<std::size_t>(edge)], end = first_[static_cast<std::size_t>(edge) + 1];
        return std::span(vertices_).subspan(first, end - first);
    }

  private:
    std::vector<std::size_t> first_;  ///< of each edge in vertices_, and one past the last
    std::vector<std::int32_t> vertices_;
};

}  // namespace oblong
