#pragma once

#include <atomic>
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
///
/// The picture is divided into bands of rows, each drawn by one thread at a time. A thread begins with the same bands
/// in every frame: pixels that it wrote before are in its core's cache, those of another thread are in that one's.
class SharedDrawing final : public SharedWork {
  public:
    /// `workers` must outlive it.
    SharedDrawing(Workers& workers, const ScreenMode& mode);

    /// Begins a frame, which must outlive end().
    void begin(const FrameContext& frame, bool takes_walls);
    /// Hands over spans of a face, one or more. They are sorted by row, and must live until end().
    void add(const TexturedFace& face, std::span<const Span> spans) { add_item({false, face, spans}); }
    /// Hands over spans of the sky, likewise. The sky is the same for all spans of a frame.
    void add_sky(const SkyNow& sky, std::span<const Span> spans);
    /// Draws until everything handed over is drawn, and ends the frame. May be called again.
    void end();

    bool is_on() const { return frame_ != nullptr; }  ///< from begin() to end()
    /// Whether walls are handed over during the walk, as their light is already known.
    bool takes_walls_at_once = false;

    bool do_part(int worker) override;

    /// Whether a picture is so large that other threads save time; in small ones most of the time goes to the walk.
    static bool is_worth_it(const ScreenMode& mode) {
        return pixel_count(mode.width_px, mode.height_px) >= pixel_count(640, 400);
    }

  private:
    /// A cache line: variables written by different threads are on different lines.
    static constexpr std::size_t kLine_bytes = 64;

    /// Spans of one face, or of the sky.
    struct Item {
        bool is_sky = false;
        TexturedFace face;
        std::span<const Span> spans;
    };
    struct alignas(kLine_bytes) Band {
        std::atomic<bool> is_taken = false;    ///< by a thread that draws it
        std::atomic<std::uint32_t> drawn = 0;  ///< as many of the first items are drawn in its rows
    };

    void begin_items();
    void add_item(const Item& item);
    std::int32_t band_at(std::int32_t step, int worker) const;
    bool draw_band(std::int32_t number, std::uint32_t item_count, int worker);
    void draw_rows(const PixelRange& rows, const Item& work, int worker);

    Workers& workers_;
    std::int32_t band_rows_;
    const FrameContext* frame_ = nullptr;
    std::vector<Item> items_;            ///< of fixed size, as other threads read items while one is written
    std::vector<PixelRange> item_rows_;  ///< of the items; apart, as they are read for each band
    SkyNow sky_{};
    std::vector<SpanScratch> scratches_;  ///< one for each worker
    std::vector<Band> bands_;
    alignas(kLine_bytes) std::atomic<std::uint32_t> item_count_ = 0;  ///< that may be drawn
};

/// Whether other threads draw at present.
inline bool is_shared(const FrameContext& frame) {
    return frame.shared && frame.shared->is_on();
}

}  // namespace oblong
