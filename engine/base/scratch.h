#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace oblong {

/// Memory for as many items as are asked for, kept and never initialised again.
template <class Item>
class Scratch {
  public:
    /// The first `count` items, with whatever they hold. Valid until more are asked for.
    std::span<Item> take(std::size_t count) {
        if (count > items_.size()) items_.resize(count);
        return std::span(items_).first(count);
    }

  private:
    std::vector<Item> items_;
};

}  // namespace oblong
