#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/table.h"
#include "engine/raster/scan.h"
#include "engine/screen/screen.h"

namespace oblong {

/// Which pixels of the screen are still free. Faces come front to back; each claims its spans, gets what was free of
/// them and owns that: no pixel is written twice, and what is free at the end is a hole in the world. A row keeps a
/// short sorted list of its free intervals, and beside it their hull, which answers most questions alone.
class SpanBuffer {
  public:
    SpanBuffer(std::int32_t width_px, std::int32_t height_px);

    /// Everything is free again.
    void reset();
    /// Appends to `owned` what was free of row y's pixels [first, end), and takes it. Columns may lie off the screen.
    void claim(std::int32_t y, std::int32_t first, std::int32_t end, std::vector<Span>& owned);
    /// The same of every row of a scanned polygon.
    void claim(const ScanlineExtents& rows, std::vector<Span>& owned);
    /// Appends all that is free, and takes it.
    void claim_rest(std::vector<Span>& owned);
    /// Whether no pixel is free.
    bool is_full() const { return free_px_ == 0; }
    /// Whether some pixel of a rectangle may be free; if not, none is.
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

    std::int32_t width_px_, height_px_;
    std::size_t row_capacity_;  ///< intervals a row can fall into: every second pixel free
    std::int64_t free_px_ = 0;
    std::vector<Row> rows_;
    std::vector<Interval> intervals_;
};

}  // namespace oblong
