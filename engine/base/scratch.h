#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace oblong {

/// A buffer that grows on demand and keeps its contents.
template <class Item>
class Scratch {
  public:
    /// The first `count` items, with old contents. Valid until a larger count is taken.
    std::span<Item> take(std::size_t count) {
        if (count > items_.size()) items_.resize(count);
        return std::span(items_).first(count);
    }

  private:
    std::vector<Item> items_;
};

}  // namespace oblong
