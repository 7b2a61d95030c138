#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/table.h"
#include "engine/raster/scan.h"
#include "engine/screen/screen.h"

namespace oblong {

/// The span buffer (S-buffer): which pixels of the screen are still free. Faces come front to back; each inserts
/// ("claims") its spans and owns the parts that were free: no pixel is written twice, and what is free at the end is a
/// hole in the world. A row keeps a short sorted list of its free spans, and its first and last free column, which
/// answer most queries alone.
class SpanBuffer {
  public:
    SpanBuffer(std::int32_t width_px, std::int32_t height_px);

    /// Everything is free again.
    void reset();
    /// These alone are free: sorted by row, then by column, and without overlap.
    void reset_to(std::span<const Span> free);
    /// Claims row y's pixels [first, end): appends those that were free to `owned`. Columns may lie off the screen.
    void claim(std::int32_t y, std::int32_t first, std::int32_t end, std::vector<Span>& owned);
    /// The same for every row of a scanned polygon.
    void claim(const ScanlineExtents& rows, std::vector<Span>& owned);
    /// Appends those pixels of a scanned polygon that are free, and leaves them free.
    void find_free(const ScanlineExtents& rows, std::vector<Span>& free) const;
    /// Claims every pixel: appends those that were free to `owned`.
    void claim_rest(std::vector<Span>& owned);
    /// The memory that it takes.
    std::size_t bytes() const { return rows_.size() * sizeof(Row) + intervals_.size() * sizeof(Interval); }
    /// Whether no pixel is free.
    bool is_full() const { return free_px_ == 0; }
    /// False only if no pixel of a rectangle is free.
    bool may_be_free(const ScreenRectangle& rectangle) const {
        for (std::int32_t y = rectangle.first_row; y < rectangle.end_row; ++y) {
            const Row& row = at(rows_, y);
            if (rectangle.first_column < row.hull_end && rectangle.end_column > row.hull_first) return true;
        }
        return false;
    }

  private:
    struct Interval {
        std::int16_t first, end;
    };
    struct Row {
        std::int32_t hull_first, hull_end, count;  ///< an empty hull: the row is full
    };

    void claim_from(Row& row, Interval* list, const Span& span, std::vector<Span>& owned);
    Interval* list_of(std::int32_t y) { return &intervals_[static_cast<std::size_t>(y) * row_capacity_]; }
    const Interval* list_of(std::int32_t y) const { return &intervals_[static_cast<std::size_t>(y) * row_capacity_]; }

    std::int32_t width_px_, height_px_;
    std::size_t row_capacity_;  ///< the most free spans of a row: every second pixel free
    std::int64_t free_px_ = 0;
    std::vector<Row> rows_;
    std::vector<Interval> intervals_;
};

}  // namespace oblong
