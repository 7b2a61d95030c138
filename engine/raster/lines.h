#pragma once

#include <array>
#include <cstdint>

#include "engine/raster/kernels/effect_kernels.h"
#include "engine/view/screen.h"

namespace oblong {

/// How the pixels of a line are found (line_walks.h). All go from pixel centre to pixel centre, set the same pixels
/// from either end, and round a tie to the larger row or column.
enum class LineMethod : std::uint8_t {
    Naive,        ///< y = m x + b for each column: steep lines have gaps, and of a vertical one there is one pixel
    Dda,          ///< steps along the longer axis and adds the slope: no gaps, but a slope of 16.16 drifts
    Bresenham,    ///< an error term instead of a slope: additions only, and each pixel is the nearest
    GuptaSproull  ///< Bresenham's, three pixels a step, each blended by its distance from the line
};
inline constexpr int kLineMethodCount = 4;
const char* name_of(LineMethod method);

/// What a line's colour makes of each colour behind it: row k where it covers k / 63 of a pixel. FogTable::levels
/// (effects/colour_tables.h) of a fog in the line's colour.
using LineBlends = std::array<ColourRow, 64>;

struct LineStyle {
    LineMethod method = LineMethod::Bresenham;
    std::uint8_t colour = 0;
    const LineBlends* blends = nullptr;  ///< read by GuptaSproull alone, which is drawn as Bresenham where it is null
};

/// Draws the line between two pixels, both included, as far as it is in the canvas. It is clipped first, in such a way
/// that the pixels are those of the whole line: any 32-bit positions will do, and cost no more.
void draw_line(PixelPosition from, PixelPosition to, const LineStyle& style, Framebuffer canvas);

}  // namespace oblong
