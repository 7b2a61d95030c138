#pragma once

#include <array>

#include "engine/library/oblong.h"

/// Which pixels the functions of oblong.h set, by definitions that look at one pixel alone: in numbers wide enough for
/// any arguments.
namespace oblong::fuzz {

/// Columns [x, x + width) of rows [y, y + height).
struct PlainRectangle {
    std::int64_t x, y, width, height;
    bool has(std::int64_t column, std::int64_t row) const;
    bool has_on_border(std::int64_t column, std::int64_t row) const;
};

/// The nearest pixel in each step along the longer axis; halves are rounded up.
bool is_on_line(PixelPosition from, PixelPosition to, PixelPosition pixel);
/// Whether a pixel's middle is less than radius + 1/2 columns away on the display.
bool is_in_circle(const ScreenMode& mode, PixelPosition middle, std::int32_t radius_px, PixelPosition pixel);
/// Whether a pixel's middle is inside, or on a left or top edge. The corners are within 2^20 pixels.
bool is_in_triangle(std::array<PixelPosition, 3> corners, PixelPosition pixel);

/// A turned picture's texel at a pixel, in doubles: kUnknown if a border between texels is so near that rounded numbers
/// may miss it, kNone outside of the picture.
inline constexpr int kUnknown = -2, kNone = -1;
int turned_texel(const Picture& picture, PixelPosition middle, std::int32_t degrees_256, std::int32_t scale_256,
                 PixelPosition pixel);

}  // namespace oblong::fuzz
