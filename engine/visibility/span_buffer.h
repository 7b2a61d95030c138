#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/table.h"
#include "engine/raster/scan.h"
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

/// The span buffer (S-buffer): which pixels of the screen are still free. Faces come front to back; each inserts
/// ("claims") its spans and owns the parts that were free. So no pixel is written twice, and a pixel free at the end is
/// a hole in the world. A row stores its first and last free column, and a sorted list of its free spans if there are
/// several.
class SpanBuffer {
  public:
    SpanBuffer(std::int32_t width_px, std::int32_t height_px);

    /// Makes every pixel free.
    void reset();
    /// Makes these spans free and no others. They are sorted by row, then column, and do not overlap.
    void reset_to(std::span<const Span> free);
    /// Claims the pixels [first, end) of row y and appends those that were free to `owned`. Columns may be off the
    /// screen.
    void claim(std::int32_t y, std::int32_t first, std::int32_t end, SpanList& owned);
    /// The same for all rows of a scanned polygon.
    void claim(const ScanlineExtents& rows, SpanList& owned);
    /// Appends the free pixels of a scanned polygon, and leaves them free.
    void find_free(const ScanlineExtents& rows, SpanList& free) const;
    /// Claims all pixels and appends those that were free to `owned`.
    void claim_rest(SpanList& owned);
    /// Memory used.
    std::size_t bytes() const { return rows_.size() * sizeof(Row) + intervals_.size() * sizeof(Interval); }
    /// Whether no pixel is free.
    bool is_full() const { return free_spans_ == 0; }
    /// Whether a pixel of a rectangle is free; one without columns lies at a border of the screen.
    bool has_free(const ScreenRectangle& rectangle) const {
        for (std::int32_t y = rectangle.first_row; y < rectangle.end_row; ++y)
            if (has_free_in_row(y, rectangle)) return true;
        return false;
    }
    /// The rectangle's rows, without those at its top and bottom that have no free pixel in its columns.
    PixelRange rows_with_free(const ScreenRectangle& rectangle) const;

  private:
    /// Free columns.
    struct Interval {
        std::int16_t first, end;
    };
    struct Row {
        Interval hull;        ///< from the first to the last free column; {width, 0} if none is free
        std::int32_t listed;  ///< spans in its list: 0 if the whole hull is free, else 2 or more

        bool may_be_free(const ScreenRectangle& rectangle) const {
            return rectangle.first_column < hull.end && rectangle.end_column > hull.first;
        }
    };

    bool has_free_in_row(std::int32_t y, const ScreenRectangle& rectangle) const {
        const Row& row = item(rows_, y);
        return row.may_be_free(rectangle) && (row.listed == 0 || has_listed(y, rectangle));
    }
    /// Whether a row's list has a free span in a rectangle's columns, which begin before the end of its hull.
    bool has_listed(std::int32_t y, const ScreenRectangle& rectangle) const;
    Span* claim_row(std::int32_t y, std::int32_t first, std::int32_t end, Span* owned);
    Span* claim_listed(std::int32_t y, std::int32_t first, std::int32_t end, Span* owned);
    Span* claim_several(std::int32_t y, std::int32_t first, std::int32_t end, Interval* free, Span* owned);
    void set_hull(Row& row, const Interval* list) const;
    Interval* list_of(std::int32_t y) { return &intervals_[as_size(y) * row_capacity_]; }
    const Interval* list_of(std::int32_t y) const { return &intervals_[as_size(y) * row_capacity_]; }

    std::int32_t width_px_, height_px_;
    Interval full_;               ///< hull of a row without free columns
    std::size_t row_capacity_;    ///< most free spans of a row: every second pixel free
    std::size_t free_spans_ = 0;  ///< in all rows
    std::vector<Row> rows_;
    std::vector<Interval> intervals_;
};

}  // namespace oblong
