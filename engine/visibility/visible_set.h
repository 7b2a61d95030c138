#pragma once

#include <cstdint>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// Which nodes and leaves of the world the eye's leaf may see, kept until the eye changes its leaf.
class VisibleSet {
  public:
    explicit VisibleSet(const Level& level);

    /// Marks what may be seen from `leaf`: everything from solid and from sky, whose own sets hold nothing but
    /// themselves.
    void see_from(const Level& level, std::int32_t leaf);
    bool has_node(std::int32_t node) const { return node_marks_[static_cast<std::size_t>(node)] == mark_; }
    bool has_leaf(std::int32_t leaf) const { return leaf_marks_[static_cast<std::size_t>(leaf)] == mark_; }
    /// Whether that leaf is neither solid nor sky.
    bool is_from_open() const { return is_from_open_; }
    /// The leaves that may be seen, each once.
    const std::vector<std::int32_t>& leaves() const { return leaves_; }

  private:
    void mark_upward(std::int32_t leaf);

    std::vector<std::int32_t> node_parents_, leaf_parents_;  ///< -1: none
    std::vector<std::uint32_t> node_marks_, leaf_marks_;
    std::vector<std::uint8_t> unpacked_;
    std::vector<std::int32_t> leaves_;
    std::uint32_t mark_ = 0;
    std::int32_t seen_from_ = -1;
    bool is_from_open_ = false;
};

}  // namespace oblong
