#include "engine/frame/shared_drawing.h"

#include <algorithm>

#include "engine/base/table.h"

namespace oblong {

namespace {

/// The most items waiting to be drawn; real levels have up to 400 in a frame.
constexpr std::size_t kMostItems = 512;

/// With more bands threads wait less for each other at the end, but most faces are in several bands, and drawing a part
/// of a face takes some time in advance.
constexpr std::int32_t kMostBands = 16, kLeastBandRows = 25;

/// The spans in these rows; spans are sorted by row.
std::span<const Span> spans_in_rows(std::span<const Span> spans, const PixelRange& rows) {
    const auto is_above = [](const Span& span, std::int32_t row) { return span.y < row; };
    const auto first = std::lower_bound(spans.begin(), spans.end(), rows.first, is_above);
    return {first, std::lower_bound(first, spans.end(), rows.end, is_above)};
}

}  // namespace

SharedDrawing::SharedDrawing(Workers& workers, const ScreenMode& mode)
    : workers_(workers),
      band_rows_(std::max(kLeastBandRows, (mode.height_px + kMostBands - 1) / kMostBands)),
      items_(kMostItems),
      item_rows_(kMostItems),
      scratches_(as_size(workers.count()), SpanScratch(mode.width_px)),
      bands_(as_size((mode.height_px + band_rows_ - 1) / band_rows_)) {}

void SharedDrawing::begin(const FrameContext& frame, bool takes_walls) {
    frame_ = &frame;
    takes_walls_at_once = takes_walls;
    begin_items();
}

void SharedDrawing::begin_items() {
    item_count_.store(0, std::memory_order_relaxed);
    for (Band& band : bands_) band.drawn.store(0, std::memory_order_relaxed);
    workers_.begin(*this);
}

void SharedDrawing::add_item(const Item& item) {
    if (item_count_.load(std::memory_order_relaxed) == kMostItems) {
        workers_.end();
        begin_items();
    }
    const std::uint32_t number = item_count_.load(std::memory_order_relaxed);
    items_[number] = item;
    item_rows_[number] = {item.spans.front().y, item.spans.back().y + 1};
    item_count_.store(number + 1, std::memory_order_release);
}

void SharedDrawing::add_sky(const SkyNow& sky, std::span<const Span> spans) {
    sky_ = sky;
    add_item({true, {}, spans});
}

void SharedDrawing::end() {
    if (!is_on()) return;
    workers_.end();
    frame_ = nullptr;
}

/// A worker's bands in its order: the first thread goes up from the lowest one, the others go down from different ones.
std::int32_t SharedDrawing::band_at(std::int32_t step, int worker) const {
    const auto count = static_cast<std::int32_t>(bands_.size());
    return worker == 0 ? count - 1 - step : ((worker - 1) * count / workers_.count() + step) % count;
}

bool SharedDrawing::do_part(int worker) {
    const std::uint32_t item_count = item_count_.load(std::memory_order_acquire);
    for (std::int32_t step = 0; step < static_cast<std::int32_t>(bands_.size()); ++step)
        if (draw_band(band_at(step, worker), item_count, worker)) return true;
    return false;
}

/// Draws the items that are not drawn in a band yet. False if there are none or another thread draws it.
bool SharedDrawing::draw_band(std::int32_t number, std::uint32_t item_count, int worker) {
    Band& band = item(bands_, number);
    const auto is_drawn = [&] { return band.drawn.load(std::memory_order_relaxed) >= item_count; };
    if (is_drawn() || band.is_taken.exchange(true, std::memory_order_acquire)) return false;
    const bool is_first = !is_drawn();  // another thread may have drawn it just before
    const PixelRange rows{number * band_rows_, (number + 1) * band_rows_};
    for (std::uint32_t next = band.drawn.load(std::memory_order_relaxed); next < item_count; ++next)
        if (item_rows_[next].first < rows.end && item_rows_[next].end > rows.first)
            draw_rows(rows, items_[next], worker);
    if (is_first) band.drawn.store(item_count, std::memory_order_relaxed);
    band.is_taken.store(false, std::memory_order_release);
    return is_first;
}

void SharedDrawing::draw_rows(const PixelRange& rows, const Item& work, int worker) {
    const std::span<const Span> spans = spans_in_rows(work.spans, rows);
    if (spans.empty()) return;
    const FrameContext& frame = *frame_;
    if (work.is_sky)
        draw_sky(spans, sky_, frame.view.ray_directions(), frame.view.projection, frame.out);
    else
        draw_textured(work.face, spans, {frame.texturing, frame.out, item(scratches_, worker)});
}

}  // namespace oblong
