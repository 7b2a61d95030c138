#include "engine/raster/depth.h"

#include <algorithm>

#include "engine/base/table.h"

namespace oblong {

namespace {

/// More rectangles than this are joined even if that adds area, as each span near one is compared with all.
constexpr std::size_t kMostRectangles = 16;

std::int64_t area_of(const ScreenRectangle& rectangle) {
    return std::int64_t{rectangle.end_column - rectangle.first_column} * (rectangle.end_row - rectangle.first_row);
}

/// The pixels that joining two rectangles adds to them; negative where they overlap more than that.
std::int64_t added_area(const ScreenRectangle& a, const ScreenRectangle& b) {
    return area_of(joined(a, b)) - area_of(a) - area_of(b);
}

/// Writes depths of `count` pixels. As 1/z is linear, it needs no clamping if both ends need none.
void fill_run(InverseZ first, InverseZ step, std::int32_t count, InverseDepth* out) {
    constexpr int kDropped = InverseZ::kFractionBits - 32;
    const auto is_within = [](InverseZ value) { return value >= InverseZ{} && value < InverseZ::from_int(1); };
    if (!is_within(first) || !is_within(stepped(first, step, static_cast<std::uint32_t>(count - 1)))) {
        for (std::int32_t i = 0; i < count; ++i) out[i] = to_inverse_depth(stepped(first, step, i));
        return;
    }
    // Moved up, so that a depth is the upper half of 64 bits.
    auto value = first.bits() << (32 - kDropped);
    const auto step_up = step.bits() << (32 - kDropped);
    for (std::int32_t i = 0; i < count; ++i, value += step_up)
        out[i] = static_cast<InverseDepth>(value >> 32) & ~kThingBit;
}

}  // namespace

void DepthBuffer::want(ScreenRectangle wanted) {
    if (area_of(wanted) <= 0) return;
    while (!rectangles_.empty()) {
        const auto nearest = std::min_element(
            rectangles_.begin(), rectangles_.end(),
            [&](const auto& a, const auto& b) { return added_area(wanted, a) < added_area(wanted, b); });
        if (added_area(wanted, *nearest) > 0 && rectangles_.size() < kMostRectangles) break;
        wanted = joined(wanted, *nearest);
        *nearest = rectangles_.back();
        rectangles_.pop_back();
    }
    rectangles_.push_back(wanted);
}

void DepthBuffer::allocate() {
    std::int32_t end_row = 0;
    first_row_ = height_px_;
    for (const ScreenRectangle& rectangle : rectangles_) {
        first_row_ = std::min(first_row_, rectangle.first_row);
        end_row = std::max(end_row, rectangle.end_row);
    }
    hulls_.resize(as_size(height_px_));
    if (end_row - first_row_ <= rows_there_) return;
    depths_.reset();
    rows_there_ = 0;  // until there are some: memory may be full
    const std::int32_t rows = end_row - first_row_;
    depths_.reset(new InverseDepth[pixel_count(width_px_, rows)]);  // uninitialised: clear() sets what is read
    rows_there_ = rows;
}

void DepthBuffer::clear() {
    allocate();
    std::fill(hulls_.begin(), hulls_.end(), Hull{});
    for (const ScreenRectangle& rectangle : rectangles_)
        for (std::int32_t y = rectangle.first_row; y < rectangle.end_row; ++y) {
            std::fill(row(y) + rectangle.first_column, row(y) + rectangle.end_column, InverseDepth{0});
            Hull& hull = item(hulls_, y);
            hull.first = std::min(hull.first, rectangle.first_column);
            hull.end = std::max(hull.end, rectangle.end_column);
        }
}

bool DepthBuffer::touches(std::span<const Span> spans, const ScreenRectangle& around) const {
    const auto overlaps = [&around](const ScreenRectangle& rectangle) { return overlap(around, rectangle); };
    return std::any_of(rectangles_.begin(), rectangles_.end(), overlaps) &&
           std::any_of(spans.begin(), spans.end(), [this](const Span& span) { return touches(span); });
}

void DepthBuffer::fill(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z) {
    for (const Span& span : spans) {
        if (!touches(span)) continue;
        for (const ScreenRectangle& rectangle : rectangles_) {
            if (span.y < rectangle.first_row || span.y >= rectangle.end_row) continue;
            const std::int32_t first = std::max(span.first, rectangle.first_column);
            const std::int32_t end = std::min(span.end, rectangle.end_column);
            if (first < end)
                fill_run(inverse_z.at_shown(first, span.y), inverse_z.per_column, end - first, row(span.y) + first);
        }
    }
}

bool DepthBuffer::is_wanted_at(std::int32_t column, std::int32_t row) const {
    return std::any_of(rectangles_.begin(), rectangles_.end(), [=](const ScreenRectangle& rectangle) {
        return column >= rectangle.first_column && column < rectangle.end_column && row >= rectangle.first_row &&
               row < rectangle.end_row;
    });
}

void DepthBuffer::append_seen(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z,
                              std::vector<Span>& seen) {
    for (const Span& span : spans) {
        if (!touches(span)) {
            seen.push_back(span);
            continue;
        }
        std::int32_t first = span.first;
        for (std::int32_t x = span.first; x < span.end; ++x) {
            const InverseDepth there = is_wanted_at(x, span.y) ? row(span.y)[x] : 0;
            if ((there & kThingBit) == 0 || there <= (to_inverse_depth(inverse_z.at(x, span.y)) | kThingBit)) continue;
            if (first < x) seen.push_back({span.y, first, x});
            first = x + 1;
        }
        if (first < span.end) seen.push_back({span.y, first, span.end});
    }
}

}  // namespace oblong
