#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/workers.h"
#include "engine/effects/sky.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/surface_pass.h"

namespace oblong {

/// Spans that several threads draw together. One of them walks through the level; the spans that a face owns are handed
/// over as it comes to them, and the others draw them meanwhile. Then it shares in the drawing until all is drawn. No
/// two spans have a pixel in common, so that the picture does not depend on which thread draws them, or when.
class SharedDrawing final : public SharedWork {
  public:
    /// `workers` outlive it. For spans of up to `longest_px` pixels.
    SharedDrawing(Workers& workers, std::int32_t longest_px);

    /// Begins to draw a frame, which outlives end().
    void begin(const FrameContext& frame, bool takes_walls);
    /// Hands over spans of a face with its surface.
    void add(const TexturedFace& face, std::span<const Span> spans);
    /// Hands over spans of the frame's sky, which lasts until end().
    void add_sky(const SkyNow& sky, std::span<const Span> spans);
    /// Shares in the drawing until all is drawn that was handed over, and ends it. May be called again.
    void end();

    bool is_on() const { return frame_ != nullptr; }  ///< from begin() to end()
    /// Whether walls are handed over while the walk goes on: their light is known. Else it is found out first.
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
    std::vector<Item> items_;  ///< as many as may wait: others read some while one more is written
    std::vector<Span> spans_;  ///< likewise
    SkyNow sky_{};
    std::size_t item_count_ = 0, span_count_ = 0;
    std::uint32_t first_item_ = 0;        ///< the number of items_[0]
    std::vector<SpanScratch> scratches_;  ///< of each worker
};

/// Whether threads share in the drawing of this frame, now.
inline bool is_shared(const FrameContext& frame) {
    return frame.shared && frame.shared->is_on();
}

}  // namespace oblong
