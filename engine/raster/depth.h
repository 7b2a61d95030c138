#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "engine/base/table.h"
#include "engine/fixed/fixed.h"
#include "engine/view/gradients.h"
#include "engine/view/screen.h"

namespace oblong {

/// 1/z as a depth buffer keeps it, in steps of 2^-32: larger is nearer, 0 is infinitely far (sky, the void), and all z
/// up to one unit are one.
using InverseDepth = std::uint32_t;

constexpr InverseDepth to_inverse_depth(InverseZ inverse_z) {
    constexpr std::int64_t kMost = std::numeric_limits<InverseDepth>::max();
    const std::int64_t steps = floor_of<32>(inverse_z);
    return static_cast<InverseDepth>(steps < 0 ? 0 : steps > kMost ? kMost : steps);
}

/// The depth of the pixels around things that are drawn into a finished picture. Faces need none (the span buffer), so
/// it is kept only in rectangles that things ask for: a frame without any takes neither time nor memory, others what
/// the rectangles' area costs. The order of calls in a frame: start_frame(), want() for each thing, clear(), fill() for
/// each face; then things may read and write pixels of the rectangles that they wanted.
class DepthBuffer {
  public:
    DepthBuffer(std::int32_t width_px, std::int32_t height_px) : width_px_(width_px), height_px_(height_px) {}

    /// No pixel is wanted.
    void start_frame() { rectangles_.clear(); }
    /// Depth will be needed in this rectangle, perhaps empty. Rectangles that overlap, or nearly touch, are joined.
    void want(ScreenRectangle rectangle);
    /// Whether a pixel is wanted.
    bool is_wanted() const { return !rectangles_.empty(); }
    /// Everything in the rectangles is infinitely far.
    void clear();
    /// Whether spans reach into the rectangles; false only if none of their pixels is wanted.
    bool touches(std::span<const Span> spans) const;
    /// Sets the depth of the wanted pixels of spans on a plane.
    void fill(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z);
    /// Appends the parts of spans on a plane at whose pixels nothing nearer is known: all that is not wanted, too.
    void append_seen(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z, std::vector<Span>& seen);

    InverseDepth* row(std::int32_t y) { return depths_.get() + std::int64_t{y} * width_px_; }
    std::span<const ScreenRectangle> rectangles() const { return rectangles_; }

  private:
    /// The columns of a row from its first to its last wanted pixel.
    struct Hull {
        std::int32_t first = std::numeric_limits<std::int32_t>::max(), end = 0;
    };

    bool touches(const Span& span) const { return span.first < at_row(span.y).end && span.end > at_row(span.y).first; }
    bool is_wanted_at(std::int32_t column, std::int32_t row) const;
    const Hull& at_row(std::int32_t y) const { return item(hulls_, y); }
    void allocate();

    std::int32_t width_px_, height_px_;
    std::vector<ScreenRectangle> rectangles_;
    std::unique_ptr<InverseDepth[]> depths_;  ///< a whole screen, not touched outside the rectangles; null until needed
    std::vector<Hull> hulls_;
};

}  // namespace oblong
