#include "engine/frame/shared_drawing.h"

#include "engine/base/table.h"

namespace oblong {

namespace {

/// The most items and spans waiting to be drawn.
constexpr std::size_t kMostItems = 512, kMostSpans = 8192;
/// About 5 microseconds of drawing: worth a hand-over to another thread, but not a long wait at the end.
constexpr std::int32_t kItemPixels = 8192;

}  // namespace

SharedDrawing::SharedDrawing(Workers& workers, std::int32_t longest_px)
    : workers_(workers),
      items_(kMostItems),
      spans_(kMostSpans),
      scratches_(as_size(workers.count()), SpanScratch(longest_px)) {}

void SharedDrawing::begin(const FrameContext& frame, bool takes_walls) {
    frame_ = &frame;
    takes_walls_at_once = takes_walls;
    item_count_ = span_count_ = 0;
    first_item_ = 0;
    workers_.begin(*this);
}

/// Makes room for an item and one span.
void SharedDrawing::make_room() {
    if (item_count_ < kMostItems && span_count_ < kMostSpans) return;
    workers_.finish_items();
    first_item_ += static_cast<std::uint32_t>(item_count_);
    item_count_ = span_count_ = 0;
}

/// Copies the first spans, as many as make one item.
std::span<const Span> SharedDrawing::copy_of_first(std::span<const Span> spans) {
    const std::size_t first = span_count_;
    std::int32_t pixels = 0;
    for (const Span& span : spans) {
        spans_[span_count_++] = span;
        pixels += span.end - span.first;
        if (pixels >= kItemPixels || span_count_ == kMostSpans) break;
    }
    return std::span(spans_).subspan(first, span_count_ - first);
}

void SharedDrawing::add_items(Item item, std::span<const Span> spans) {
    while (!spans.empty()) {
        make_room();
        item.spans = copy_of_first(spans);
        items_[item_count_++] = item;
        workers_.add_item();
        spans = spans.subspan(item.spans.size());
    }
}

void SharedDrawing::add(const TexturedFace& face, std::span<const Span> spans) {
    add_items({false, face, {}}, spans);
}

void SharedDrawing::add_sky(const SkyNow& sky, std::span<const Span> spans) {
    sky_ = sky;
    Item item;
    item.is_sky = true;
    add_items(item, spans);
}

void SharedDrawing::end() {
    if (!is_on()) return;
    workers_.finish_items();
    workers_.end();
    frame_ = nullptr;
}

void SharedDrawing::do_item(std::uint32_t number, int worker) {
    const FrameContext& frame = *frame_;
    const Item& work = items_[number - first_item_];
    if (work.is_sky) {
        draw_sky(work.spans, sky_, frame.view.ray_directions(), frame.view.projection, frame.out,
                 frame.settings.kernels->draw_blocks);
        return;
    }
    draw_textured(work.face, work.spans, {frame.texturing, frame.out, item(scratches_, worker)});
}

}  // namespace oblong
