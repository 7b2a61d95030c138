#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/workers.h"
#include "engine/effects/sky.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/surface_pass.h"

namespace oblong {

/// Drawing of spans by several threads. One thread walks through the level and hands over the spans that faces own; the
/// others draw them meanwhile. At the end the first thread draws too, until all is done. Spans have no pixels in
/// common, so the picture does not depend on the threads.
class SharedDrawing final : public SharedWork {
  public:
    /// `workers` must outlive it. For spans of up to `longest_px` pixels.
    SharedDrawing(Workers& workers, std::int32_t longest_px);

    /// Begins a frame, which must outlive end().
    void begin(const FrameContext& frame, bool takes_walls);
    /// Hands over spans of a face.
    void add(const TexturedFace& face, std::span<const Span> spans);
    /// Hands over spans of the sky. They are copied; its texels must live until end().
    void add_sky(const SkyNow& sky, std::span<const Span> spans);
    /// Draws until everything handed over is drawn, and ends the frame. May be called again.
    void end();

    bool is_on() const { return frame_ != nullptr; }  ///< from begin() to end()
    /// Whether walls are handed over during the walk, as their light is already known.
    bool takes_walls_at_once = false;

    void do_item(std::uint32_t item, int worker) override;

  private:
    /// Spans of one face, or of the sky.
    struct Item {
        bool is_sky = false;
        TexturedFace face;
        std::span<const Span> spans;  ///< in spans_
    };

    std::span<const Span> copy_of_first(std::span<const Span> spans);
    void make_room();
    void add_items(Item item, std::span<const Span> spans);

    Workers& workers_;
    const FrameContext* frame_ = nullptr;
    std::vector<Item> items_;  ///< of fixed size, as other threads read items while one is written
    std::vector<Span> spans_;  ///< of fixed size, too
    SkyNow sky_{};
    std::size_t item_count_ = 0, span_count_ = 0;
    std::uint32_t first_item_ = 0;        ///< the number of items_[0]
    std::vector<SpanScratch> scratches_;  ///< one for each worker
};

/// Whether other threads draw at present.
inline bool is_shared(const FrameContext& frame) {
    return frame.shared && frame.shared->is_on();
}

}  // namespace oblong
