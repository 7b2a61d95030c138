#pragma once

#include <array>
#include <cstdint>

#include "engine/raster/kernels/effect_kernels.h"
#include "engine/view/screen.h"

namespace oblong {

/// The algorithms for lines (line_walks.h). All draw from pixel centre to pixel centre, set the same pixels from either
/// end, and round ties to the larger row or column.
enum class LineMethod : std::uint8_t {
    Naive,        ///< y = m x + b for each column: steep lines have gaps, vertical ones are a single pixel
    Dda,          ///< steps along the longer axis and adds the slope: no gaps, but a slope of 16.16 drifts
    Bresenham,    ///< an error term instead of a slope: additions only, always the nearest pixel
    GuptaSproull  ///< as Bresenham, but three pixels a step, each blended by its distance from the line
};
inline constexpr int kLineMethodCount = 4;

/// A line's colour blended with each colour behind it; row k is for a coverage of k / 63. It is FogTable::levels
/// (effects/colour_tables.h) of fog in the line's colour.
using LineBlends = std::array<ColourRow, 64>;

struct LineStyle {
    LineMethod method = LineMethod::Bresenham;
    std::uint8_t colour = 0;
    const LineBlends* blends = nullptr;  ///< for GuptaSproull, which is drawn as Bresenham if null
};

/// Draws the part of a line between two pixels, both included, that is in the canvas. Clipping does not change which
/// pixels are set. Any 32-bit positions are valid, at no extra cost.
void draw_line(PixelPosition from, PixelPosition to, const LineStyle& style, Framebuffer canvas);

}  // namespace oblong
