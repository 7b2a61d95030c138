#include "engine/visibility/span_buffer.h"

#include <algorithm>
#include <utility>

#include "engine/base/table.h"

namespace oblong {

namespace {

/// A column of a screen, as lists store it.
std::int16_t column(std::int32_t x) {
    return static_cast<std::int16_t>(x);
}

/// Lists are short: swaps in a loop are faster than a call of memmove.
template <class Interval>
void insert(Interval added, Interval* place, Interval* list_end) {
    for (; place != list_end; ++place) std::swap(*place, added);
    *place = added;
}

template <class Interval>
void erase(Interval* place, Interval* list_end) {
    for (Interval moved{}; list_end != place;) std::swap(*--list_end, moved);
}

}  // namespace

SpanBuffer::SpanBuffer(std::int32_t width_px, std::int32_t height_px)
    : width_px_(width_px),
      height_px_(height_px),
      full_{column(width_px), 0},
      row_capacity_(as_size(width_px) / 2 + 2),
      rows_(as_size(height_px)),
      intervals_(row_capacity_ * as_size(height_px)) {
    reset();
}

void SpanBuffer::reset() {
    std::fill(rows_.begin(), rows_.end(), Row{{0, column(width_px_)}, 0});
    free_spans_ = rows_.size();
}

void SpanBuffer::reset_to(std::span<const Span> free) {
    std::fill(rows_.begin(), rows_.end(), Row{});
    free_spans_ = 0;
    for (const Span& span : free) {
        Row& row = item(rows_, span.y);
        Interval* const list_end = list_of(span.y) + row.listed;
        if (row.listed > 0 && list_end[-1].end == span.first) {
            list_end[-1].end = column(span.end);
        } else {
            *list_end = {column(span.first), column(span.end)};
            ++row.listed;
            ++free_spans_;
        }
    }
    for (std::int32_t y = 0; y < height_px_; ++y) set_hull(item(rows_, y), list_of(y));
}

bool SpanBuffer::has_listed(std::int32_t y, const ScreenRectangle& rectangle) const {
    const Interval* free = list_of(y);
    while (free->end <= rectangle.first_column) ++free;  // ends: the last free span ends where the hull does
    return free->first < rectangle.end_column;
}

PixelRange SpanBuffer::rows_with_free(const ScreenRectangle& rectangle) const {
    std::int32_t first = rectangle.first_row, end = rectangle.end_row;
    while (first < end && !has_free_in_row(first, rectangle)) ++first;
    while (first < end && !has_free_in_row(end - 1, rectangle)) --end;
    return {first, end};
}

void SpanBuffer::claim(const ScanlineExtents& rows, SpanList& owned) {
    Span* to = owned.room_for(free_spans_);
    const std::int32_t* const left = rows.left.data();
    const std::int32_t* const right = rows.right.data();
    for (std::int32_t y = rows.first, end = rows.end; y < end; ++y) to = claim_row(y, left[y], right[y], to);
    owned.set_end(to);
}

void SpanBuffer::claim(std::int32_t y, std::int32_t first, std::int32_t end, SpanList& owned) {
    owned.set_end(claim_row(y, first, end, owned.room_for(row_capacity_)));
}

void SpanBuffer::claim_rest(SpanList& owned) {
    if (is_full()) return;
    for (std::int32_t y = 0; y < height_px_; ++y) claim(y, 0, width_px_, owned);
}

/// Claims the free parts of row y's pixels [first, end), writes them to `owned`, and returns the end of what it wrote.
[[gnu::always_inline]] inline Span* SpanBuffer::claim_row(std::int32_t y, std::int32_t first, std::int32_t end,
                                                          Span* owned) {
    Row& row = item(rows_, y);
    first = std::max<std::int32_t>(first, row.hull.first);
    end = std::min<std::int32_t>(end, row.hull.end);
    if (first >= end) return owned;
    if (row.listed > 0) return claim_listed(y, first, end, owned);
    *owned = {y, first, end};
    const bool keeps_left = first > row.hull.first, keeps_right = end < row.hull.end;
    if (keeps_left && keeps_right) {
        Interval* const list = list_of(y);
        list[0] = {row.hull.first, column(first)};
        list[1] = {column(end), row.hull.end};
        row.listed = 2;
        ++free_spans_;
    } else if (keeps_left) {
        row.hull.end = column(first);
    } else if (keeps_right) {
        row.hull.first = column(end);
    } else {
        row.hull = full_;
        --free_spans_;
    }
    return owned + 1;
}

/// The same for a row with a list; columns are within its hull.
[[gnu::always_inline]] inline Span* SpanBuffer::claim_listed(std::int32_t y, std::int32_t first, std::int32_t end,
                                                             Span* owned) {
    Row& row = item(rows_, y);
    Interval* const list = list_of(y);
    Interval* free = list;
    while (free->end <= first) ++free;  // ends: `first` is within the hull
    if (free->end < end) return claim_several(y, first, end, free, owned);
    first = std::max<std::int32_t>(first, free->first);
    if (first >= end) return owned;
    *owned = {y, first, end};
    const bool keeps_left = first > free->first, keeps_right = end < free->end;
    if (keeps_left && keeps_right) {
        insert(Interval{column(end), free->end}, free + 1, list + row.listed);
        free->end = column(first);
        ++row.listed;
        ++free_spans_;
        return owned + 1;
    }
    if (keeps_left) {
        free->end = column(first);
    } else if (keeps_right) {
        free->first = column(end);
    } else {
        erase(free, list + row.listed);
        --row.listed;
        --free_spans_;
    }
    row.hull = {list[0].first, list[row.listed - 1].end};
    if (row.listed == 1) row.listed = 0;
    return owned + 1;
}

/// The same for columns that reach beyond the first free span that they touch.
Span* SpanBuffer::claim_several(std::int32_t y, std::int32_t first, std::int32_t end, Interval* free, Span* owned) {
    Row& row = item(rows_, y);
    Interval* const list_end = list_of(y) + row.listed;
    if (free->first < first) {
        *owned++ = {y, first, free->end};
        free->end = column(first);
        ++free;
    }
    Interval* const taken = free;
    for (; free != list_end && free->end <= end; ++free) *owned++ = {y, free->first, free->end};
    if (free != list_end && free->first < end) {
        *owned++ = {y, free->first, end};
        free->first = column(end);
    }
    std::copy(free, list_end, taken);
    row.listed -= static_cast<std::int32_t>(free - taken);
    free_spans_ -= as_size(free - taken);
    set_hull(row, list_of(y));
    return owned;
}

/// Sets a row's hull from its list; a list of one span is dropped.
inline void SpanBuffer::set_hull(Row& row, const Interval* list) const {
    row.hull = row.listed > 0 ? Interval{list[0].first, list[row.listed - 1].end} : full_;
    if (row.listed == 1) row.listed = 0;
}

void SpanBuffer::find_free(const ScanlineExtents& rows, SpanList& free) const {
    Span* to = free.room_for(free_spans_);
    for (std::int32_t y = rows.first; y < rows.end; ++y) {
        const Row& row = item(rows_, y);
        const std::span intervals =
            row.listed > 0 ? std::span(list_of(y), as_size(row.listed)) : std::span(&row.hull, 1);
        for (const Interval& interval : intervals) {
            const std::int32_t first = std::max<std::int32_t>(interval.first, item(rows.left, y));
            const std::int32_t end = std::min<std::int32_t>(interval.end, item(rows.right, y));
            if (first < end) *to++ = {y, first, end};
        }
    }
    free.set_end(to);
}

}  // namespace oblong
