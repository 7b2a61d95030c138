#pragma once

#include <array>
#include <cstdint>

#include "engine/base/table.h"

namespace oblong {

inline constexpr int kGlyphWidth_px = 5, kGlyphHeight_px = 8, kGlyphAdvance_px = 6, kLineHeight_px = 10;
inline constexpr char kFirstGlyph = ' ';
inline constexpr int kGlyphCount = 95;  ///< ' ' to '~'

/// Eight rows, top to bottom, the last for descenders; bit 4 is the leftmost of five pixels.
using Glyph = std::array<std::uint8_t, kGlyphHeight_px>;

/// Whether a glyph's pixel is set; `column` from the left.
constexpr bool is_drawn(const Glyph& glyph, int row, int column) {
    return (item(glyph, row) >> (kGlyphWidth_px - 1 - column) & 1) != 0;
}

/// The glyph of an ASCII character; a question mark for others.
const Glyph& glyph_of(char character);

}  // namespace oblong
