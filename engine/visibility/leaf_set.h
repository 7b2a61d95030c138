#pragma once

#include <cstdint>

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

}  // namespace oblong
