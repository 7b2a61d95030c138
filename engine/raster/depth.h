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

/// 1/z in a depth buffer, in steps of 2^-32: larger is nearer, 0 is infinitely far (sky, the void), and all z up to one
/// unit are equal. The lowest bit is no part of it: in the buffer it is set where a thing was drawn. Things compare and
/// are drawn with it, and so over all that is equally deep.
using InverseDepth = std::uint32_t;
inline constexpr InverseDepth kThingBit = 1;

/// The even number below.
constexpr InverseDepth to_inverse_depth(InverseZ inverse_z) {
    constexpr std::int64_t kMost = std::numeric_limits<InverseDepth>::max();
    const std::int64_t steps = floor_of<32>(inverse_z);
    return static_cast<InverseDepth>(steps < 0 ? 0 : steps > kMost ? kMost : steps) & ~kThingBit;
}

/// The depth of pixels, for things that are drawn after the faces. Faces need none (span buffer), so it is kept only in
/// the rectangles requested for things: time and memory depend on their area, and are zero without any. Calls in a
/// frame: start_frame(), want() for each thing, clear(), fill() for each face; then depths in the requested rectangles
/// may be read and written.
class DepthBuffer {
  public:
    DepthBuffer(std::int32_t width_px, std::int32_t height_px) : width_px_(width_px), height_px_(height_px) {}

    /// Drops all rectangles.
    void start_frame() { rectangles_.clear(); }
    /// Requests depth in a rectangle, which may be empty. Rectangles that overlap or nearly touch are joined.
    void want(ScreenRectangle rectangle);
    /// Whether depth of any pixel was requested.
    bool is_wanted() const { return !rectangles_.empty(); }
    /// Sets all depths in the rectangles to infinitely far.
    void clear();
    /// False only if no pixel of the spans, which `around` holds, is in the rectangles.
    bool touches(std::span<const Span> spans, const ScreenRectangle& around) const;
    /// Sets the depth of those pixels of spans on a plane that are in the rectangles.
    void fill(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z);
    /// Appends the parts of spans on a plane where no thing is nearer, including all pixels outside the rectangles.
    /// Faces do not count: whether they have depth depends on things that nobody sees.
    void append_seen(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z, std::vector<Span>& seen);

    /// Row y, which must be in a rectangle.
    InverseDepth* row(std::int32_t y) { return depths_.get() + std::int64_t{y - first_row_} * width_px_; }
    std::span<const ScreenRectangle> rectangles() const { return rectangles_; }

  private:
    /// A row's columns from the first to the last in a rectangle.
    struct Hull {
        std::int32_t first = std::numeric_limits<std::int32_t>::max(), end = 0;
    };

    bool touches(const Span& span) const { return span.first < at_row(span.y).end && span.end > at_row(span.y).first; }
    bool is_wanted_at(std::int32_t column, std::int32_t row) const;
    const Hull& at_row(std::int32_t y) const { return item(hulls_, y); }
    void allocate();

    std::int32_t width_px_, height_px_;
    std::vector<ScreenRectangle> rectangles_;
    std::unique_ptr<InverseDepth[]> depths_;       ///< of whole rows, used inside the rectangles only
    std::int32_t first_row_ = 0, rows_there_ = 0;  ///< of `depths_`: what frames so far needed
    std::vector<Hull> hulls_;
};

}  // namespace oblong
