#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/base/table.h"
#include "engine/view/screen.h"

namespace oblong {

/// Spans in the order in which they were added. To add many, make room for the most there may be, then write them
/// without a check each.
class SpanList {
  public:
    const Span* begin() const { return spans_.data(); }
    const Span* end() const { return spans_.data() + used_; }
    const Span* data() const { return spans_.data(); }
    std::size_t size() const { return used_; }
    bool empty() const { return used_ == 0; }
    void clear() { used_ = 0; }

    /// The end, where `count` more spans may be written; call set_end() to keep them.
    Span* room_for(std::size_t count) {
        if (capacity_ - used_ < count) grow(count);
        return spans_.data() + used_;
    }
    void set_end(const Span* end) { used_ = as_size(end - spans_.data()); }

    void push_back(const Span& span) {
        *room_for(1) = span;
        ++used_;
    }

  private:
    void grow(std::size_t count) {
        capacity_ = std::max(used_ + count, 2 * capacity_);
        spans_.resize(capacity_);
    }

    std::vector<Span> spans_;  ///< `used_` of them, then room for more
    std::size_t used_ = 0, capacity_ = 0;
};

}  // namespace oblong
