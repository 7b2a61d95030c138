#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/fixed/fixed.h"

namespace oblong {

/// A mode's size in pixels and the shape of its display. Only make_projection() (view/projection.h) and layout()
/// (view/present_rect.h) read the pixel aspect.
struct ScreenMode {
    std::int32_t width_px = 320, height_px = 200;
    Ratio display{4, 3};  ///< width to height of the whole picture as shown

    /// Width to height of a shown pixel: 5:6 for 320x200 on 4:3 (Muratori: 1/a).
    constexpr Ratio pixel() const { return display * Ratio{height_px, width_px}; }
    constexpr bool operator==(const ScreenMode&) const = default;
};

/// The largest width and height that the engine's formats allow (engine/fixed/README.md).
inline constexpr std::int32_t kLargestMode_px = 4096;

inline constexpr Screen kHalfPixel = Screen::from_raw(128);  ///< from a pixel's edge to its centre

/// A vertex on the screen, pixels. Pixel centres are at +0.5.
struct ScreenVertex {
    Screen x, y;
    constexpr bool operator==(const ScreenVertex&) const = default;
};

/// A pixel's position; may be off the screen.
struct PixelPosition {
    std::int32_t column = 0, row = 0;
    constexpr bool operator==(const PixelPosition&) const = default;
};

/// Columns [first_column, end_column) of rows [first_row, end_row); inside the screen, may be empty.
struct ScreenRectangle {
    std::int32_t first_column, end_column, first_row, end_row;
};
/// Whether two rectangles that are not empty share a pixel.
inline bool overlap(const ScreenRectangle& a, const ScreenRectangle& b) {
    return a.first_column < b.end_column && b.first_column < a.end_column && a.first_row < b.end_row &&
           b.first_row < a.end_row;
}
inline bool is_empty(const ScreenRectangle& pixels) {
    return pixels.first_column >= pixels.end_column || pixels.first_row >= pixels.end_row;
}
inline ScreenRectangle intersection(const ScreenRectangle& a, const ScreenRectangle& b) {
    return {std::max(a.first_column, b.first_column), std::min(a.end_column, b.end_column),
            std::max(a.first_row, b.first_row), std::min(a.end_row, b.end_row)};
}
/// The least rectangle that holds two that are not empty.
inline ScreenRectangle joined(const ScreenRectangle& a, const ScreenRectangle& b) {
    return {std::min(a.first_column, b.first_column), std::max(a.end_column, b.end_column),
            std::min(a.first_row, b.first_row), std::max(a.end_row, b.end_row)};
}

/// Columns or rows [first, end); may be empty.
struct PixelRange {
    std::int32_t first, end;
};

/// Pixels [first, end) of row y.
struct Span {
    std::int32_t y, first, end;
};

/// A non-owning view of an 8-bit framebuffer: one palette index a pixel, rows top to bottom, `pitch` bytes apart.
struct Framebuffer {
    std::uint8_t* pixels = nullptr;
    std::int32_t width_px = 0, height_px = 0, pitch = 0;

    std::uint8_t* row(std::int32_t y) const { return pixels + static_cast<std::int64_t>(y) * pitch; }
};

constexpr std::size_t pixel_count(std::int32_t width_px, std::int32_t height_px) {
    return as_size(width_px) * as_size(height_px);
}

/// The bounding rectangle of spans sorted by row; empty if there are none.
inline ScreenRectangle rectangle_around(std::span<const Span> spans) {
    if (spans.empty()) return {};
    ScreenRectangle around{spans.front().first, spans.front().end, spans.front().y, spans.back().y + 1};
    for (const Span& span : spans) {
        around.first_column = std::min(around.first_column, span.first);
        around.end_column = std::max(around.end_column, span.end);
    }
    return around;
}

inline void fill_spans(std::span<const Span> spans, std::uint8_t colour, Framebuffer out) {
    for (const Span& span : spans) std::fill(out.row(span.y) + span.first, out.row(span.y) + span.end, colour);
}

}  // namespace oblong
