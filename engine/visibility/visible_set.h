#pragma once

#include <cstdint>
#include <vector>

#include "engine/level/level.h"
#include "engine/visibility/leaf_set.h"

namespace oblong {

/// The nodes and leaves of the world that may be visible from the eye's leaf (PVS), kept until the eye is in another
/// leaf.
class VisibleSet {
  public:
    explicit VisibleSet(const Level& level);

    /// Marks what may be visible from `leaf`; from solid and sky everything, as their PVS holds only themselves.
    void see_from(const Level& level, LeafIndex leaf);
    bool has_node(NodeIndex node) const { return node_marks_[node] == mark_; }
    bool has_leaf(LeafIndex leaf) const { return leaf_set_.has(leaf); }
    const LeafSet& leaf_set() const { return leaf_set_; }
    /// Whether the eye's leaf is neither solid nor sky.
    bool is_from_open() const { return is_from_open_; }
    const std::vector<LeafIndex>& leaves() const { return leaves_; }

  private:
    void mark_upward(LeafIndex leaf);

    Table<NodeIndex, Node> node_parents_;
    Table<NodeIndex, Leaf> leaf_parents_;
    Table<std::uint32_t, Node> node_marks_;
    LeafSet leaf_set_;
    std::vector<std::uint8_t> unpacked_;
    std::vector<LeafIndex> leaves_;
    std::uint32_t mark_ = 0;
    LeafIndex seen_from_ = LeafIndex::none();
    bool is_from_open_ = false;
};

}  // namespace oblong
