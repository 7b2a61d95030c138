#include "engine/visibility/span_buffer.h"

#include <algorithm>

#include "engine/base/table.h"

namespace oblong {

SpanBuffer::SpanBuffer(std::int32_t width_px, std::int32_t height_px)
    : width_px_(width_px),
      height_px_(height_px),
      row_capacity_(static_cast<std::size_t>(width_px) / 2 + 2),
      rows_(static_cast<std::size_t>(height_px)),
      intervals_(row_capacity_ * static_cast<std::size_t>(height_px)) {
    reset();
}

void SpanBuffer::reset() {
    for (std::int32_t y = 0; y < height_px_; ++y) {
        at(rows_, y) = {0, width_px_, 1};
        list_of(y)[0] = {0, static_cast<std::int16_t>(width_px_)};
    }
    free_px_ = std::int64_t{width_px_} * height_px_;
}

void SpanBuffer::reset_to(std::span<const Span> free) {
    for (Row& row : rows_) row = {width_px_, 0, 0};
    free_px_ = 0;
    for (const Span& span : free) {
        Row& row = at(rows_, span.y);
        Interval* const list = list_of(span.y);
        const auto first = static_cast<std::int16_t>(span.first), end = static_cast<std::int16_t>(span.end);
        if (row.count > 0 && list[row.count - 1].end == first)
            list[row.count - 1].end = end;
        else
            list[row.count++] = {first, end};
        row.hull_first = list[0].first;
        row.hull_end = end;
        free_px_ += span.end - span.first;
    }
}

void SpanBuffer::claim(std::int32_t y, std::int32_t first, std::int32_t end, std::vector<Span>& owned) {
    Row& row = at(rows_, y);
    first = std::max(first, row.hull_first);
    end = std::min(end, row.hull_end);
    if (first >= end) return;
    claim_from(row, list_of(y), {y, first, end}, owned);
}

void SpanBuffer::claim(const ScanlineExtents& rows, std::vector<Span>& owned) {
    for (std::int32_t y = rows.first; y < rows.end; ++y) claim(y, at(rows.left, y), at(rows.right, y), owned);
}

void SpanBuffer::find_free(const ScanlineExtents& rows, std::vector<Span>& free) const {
    for (std::int32_t y = rows.first; y < rows.end; ++y) {
        const std::span intervals(list_of(y), static_cast<std::size_t>(at(rows_, y).count));
        for (const Interval& interval : intervals) {
            const std::int32_t first = std::max<std::int32_t>(interval.first, at(rows.left, y));
            const std::int32_t end = std::min<std::int32_t>(interval.end, at(rows.right, y));
            if (first < end) free.push_back({y, first, end});
        }
    }
}

void SpanBuffer::claim_from(Row& row, Interval* list, const Span& span, std::vector<Span>& owned) {
    Interval* const list_end = list + row.count;
    Interval* read = list;
    while (read != list_end && read->end <= span.first) ++read;
    if (read == list_end || read->first >= span.end) return;

    Interval* write = read;
    if (read->first < span.first && read->end > span.end) {  // falls in two
        std::copy_backward(read, list_end, list_end + 1);
        ++row.count;
        write[0].end = static_cast<std::int16_t>(span.first);
        write[1].first = static_cast<std::int16_t>(span.end);
        owned.push_back(span);
        free_px_ -= span.end - span.first;
        return;
    }
    for (; read != list_end && read->first < span.end; ++read) {
        const Interval free = *read;
        const Span piece{span.y, std::max<std::int32_t>(free.first, span.first),
                         std::min<std::int32_t>(free.end, span.end)};
        owned.push_back(piece);
        free_px_ -= piece.end - piece.first;
        if (free.first < piece.first) *write++ = {free.first, static_cast<std::int16_t>(piece.first)};
        if (free.end > piece.end) *write++ = {static_cast<std::int16_t>(piece.end), free.end};
    }
    write = std::copy(read, list_end, write);
    row.count = static_cast<std::int32_t>(write - list);
    row.hull_first = row.count ? list[0].first : width_px_;
    row.hull_end = row.count ? write[-1].end : 0;
}

void SpanBuffer::claim_rest(std::vector<Span>& owned) {
    for (std::int32_t y = 0; y < height_px_; ++y) claim(y, 0, width_px_, owned);
}

}  // namespace oblong
