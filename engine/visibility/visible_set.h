#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// A set of a level's leaves, cleared in constant time.
class LeafSet {
  public:
    explicit LeafSet(std::size_t leaves) : marks_(leaves) {}

    void clear() { ++mark_; }
    void add(LeafIndex leaf) { marks_[leaf] = mark_; }
    bool has(LeafIndex leaf) const { return marks_[leaf] == mark_; }

  private:
    Table<std::uint32_t, Leaf> marks_;
    std::uint32_t mark_ = 1;
};

/// The nodes and leaves of the world that may be visible from the eye's leaf (PVS), kept until the eye is in another
/// leaf.
class VisibleSet {
  public:
    /// Copies share what the level alone decides.
    explicit VisibleSet(const Level& level);

    /// Marks what may be visible from `leaf`; from solid and sky everything, as their PVS holds only themselves.
    void see_from(const Level& level, LeafIndex leaf);
    LeafIndex seen_from() const { return seen_from_; }
    bool has_node(NodeIndex node) const { return node_marks_[node] == mark_; }
    bool has_leaf(LeafIndex leaf) const { return leaf_set_.has(leaf); }
    const LeafSet& leaf_set() const { return leaf_set_; }
    /// Whether the eye's leaf is neither solid nor sky.
    bool is_from_open() const { return is_from_open_; }

  private:
    struct Parents {
        Table<NodeIndex, Node> of_nodes;
        Table<NodeIndex, Leaf> of_leaves;
    };
    static std::shared_ptr<const Parents> parents_in(const Level& level);
    void mark_upward(LeafIndex leaf);

    std::shared_ptr<const Parents> parents_;
    Table<std::uint32_t, Node> node_marks_;
    LeafSet leaf_set_;
    std::vector<std::uint8_t> unpacked_;
    std::uint32_t mark_ = 0;
    LeafIndex seen_from_ = LeafIndex::none();
    bool is_from_open_ = false;
};

}  // namespace oblong
