#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "game/simulation/geometry.h"

namespace oblong {

/// Boxes in a tree of boxes around them: finding those at a place looks at few of the others.
class BoxTree {
  public:
    struct Entry {
        Box box;
        std::uint32_t number;
    };

    BoxTree() = default;
    explicit BoxTree(std::vector<Entry> entries);

    /// The numbers of the boxes that overlap an area, in ascending order.
    std::vector<std::uint32_t> overlapping(const Box& area) const;

  private:
    /// Of entries [first, end). The first child is the next node.
    struct Node {
        Box bounds;
        std::uint32_t first, end;
        std::uint32_t second_child = 0;  ///< 0: no children
    };

    void add_node(std::uint32_t first, std::uint32_t end);
    void collect(std::uint32_t node, const Box& area, std::vector<std::uint32_t>& found) const;

    std::vector<Entry> entries_;
    std::vector<Node> nodes_;
};

}  // namespace oblong
