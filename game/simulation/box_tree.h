#pragma once

#include <cstdint>
#include <vector>

#include "game/simulation/geometry.h"

namespace oblong {

/// A tree of bounding boxes: finds the boxes at a place without looking at all of them.
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

    /// Some of the overlapping boxes, for bounded work: at most kMostFound, after at most kMostLooks box tests.
    struct Part {
        std::vector<std::uint32_t> numbers;  ///< in ascending order
        std::uint32_t next = 0;              ///< where to continue; 0: nothing is left
        std::uint32_t looks = 0;
    };
    static constexpr std::uint32_t kMostFound = 256, kMostLooks = 2048;

    /// `from` is 0, or `next` of an earlier answer. The order of the entries is the same in every build.
    Part part_overlapping(const Box& area, std::uint32_t from = 0) const;

    std::size_t size() const { return entries_.size(); }

  private:
    /// Holds entries [first, end). The first child is the next node.
    struct Node {
        Box bounds;
        std::uint32_t first, end;
        std::uint32_t second_child = 0;  ///< 0: no children
    };

    void add_node(std::uint32_t first, std::uint32_t end);
    bool collect_part(std::uint32_t node, const Box& area, std::uint32_t from, Part& part) const;

    std::vector<Entry> entries_;
    std::vector<Node> nodes_;
};

}  // namespace oblong
