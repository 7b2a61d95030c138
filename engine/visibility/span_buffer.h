#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/table.h"
#include "engine/raster/scan.h"
#include "engine/view/screen.h"
#include "engine/visibility/span_list.h"

namespace oblong {

/// The span buffer (S-buffer): which pixels of the screen are still free. Faces come front to back; each inserts
/// ("claims") its spans and owns the parts that were free: no pixel is written twice, and what is free at the end is a
/// hole in the world. A row keeps its first and last free column, and a short sorted list of its free spans where they
/// are several.
class SpanBuffer {
  public:
    SpanBuffer(std::int32_t width_px, std::int32_t height_px);

    /// Everything is free again.
    void reset();
    /// These alone are free: sorted by row, then by column, and without overlap.
    void reset_to(std::span<const Span> free);
    /// Claims row y's pixels [first, end): appends those that were free to `owned`. Columns may lie off the screen.
    void claim(std::int32_t y, std::int32_t first, std::int32_t end, SpanList& owned);
    /// The same for every row of a scanned polygon.
    void claim(const ScanlineExtents& rows, SpanList& owned);
    /// Appends those pixels of a scanned polygon that are free, and leaves them free.
    void find_free(const ScanlineExtents& rows, SpanList& free) const;
    /// Claims every pixel: appends those that were free to `owned`.
    void claim_rest(SpanList& owned);
    /// The memory that it takes.
    std::size_t bytes() const { return rows_.size() * sizeof(Row) + intervals_.size() * sizeof(Interval); }
    /// Whether no pixel is free.
    bool is_full() const { return free_spans_ == 0; }
    /// False only if no pixel of a rectangle is free.
    bool may_be_free(const ScreenRectangle& rectangle) const {
        for (std::int32_t y = rectangle.first_row; y < rectangle.end_row; ++y)
            if (at(rows_, y).may_be_free(rectangle)) return true;
        return false;
    }
    /// A rectangle's rows, but for those at its top and its bottom that have no free pixel in it.
    PixelRange rows_with_free(const ScreenRectangle& rectangle) const;

  private:
    /// Free columns.
    struct Interval {
        std::int16_t first, end;
    };
    struct Row {
        Interval hull;        ///< holds all free columns; of a full row {width, 0}
        std::int32_t listed;  ///< how many spans its list has: none if all of the hull is free, else two or more

        bool may_be_free(const ScreenRectangle& rectangle) const {
            return rectangle.first_column < hull.end && rectangle.end_column > hull.first;
        }
    };

    Span* claim_row(std::int32_t y, std::int32_t first, std::int32_t end, Span* owned);
    Span* claim_listed(std::int32_t y, std::int32_t first, std::int32_t end, Span* owned);
    Span* claim_several(std::int32_t y, std::int32_t first, std::int32_t end, Interval* free, Span* owned);
    void settle(Row& row, const Interval* list) const;
    Interval* list_of(std::int32_t y) { return &intervals_[static_cast<std::size_t>(y) * row_capacity_]; }
    const Interval* list_of(std::int32_t y) const { return &intervals_[static_cast<std::size_t>(y) * row_capacity_]; }

    std::int32_t width_px_, height_px_;
    Interval full_;               ///< the hull of a row without free columns
    std::size_t row_capacity_;    ///< the most free spans of a row: every second pixel free
    std::size_t free_spans_ = 0;  ///< of all rows
    std::vector<Row> rows_;
    std::vector<Interval> intervals_;
};

}  // namespace oblong
