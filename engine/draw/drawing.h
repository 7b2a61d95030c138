#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/surface/palette.h"
#include "engine/view/screen.h"

namespace oblong {

/// Columns [x, x + width) of rows [y, y + height); may be partly outside the canvas.
struct Area {
    std::int32_t x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Area&) const = default;
};

/// The part of an area inside the canvas.
Area clipped(const Area& area, Framebuffer canvas);
/// The part of a canvas inside an area, as a canvas.
Framebuffer part_of(Framebuffer canvas, const Area& area);

/// Sets a pixel. This and the functions below ignore pixels outside the canvas.
void set_pixel(Framebuffer canvas, std::int32_t x, std::int32_t y, std::uint8_t colour);
void fill_area(Framebuffer canvas, const Area& area, std::uint8_t colour);
/// Fills the outermost pixels of an area.
void draw_border(Framebuffer canvas, const Area& area, std::uint8_t colour);
/// Maps colours to colours.
using ColourTable = std::array<std::uint8_t, 256>;
/// Replaces each colour by its entry in a table.
void recolour_area(Framebuffer canvas, const Area& area, const ColourTable& table);

/// Maps each colour to the palette's nearest colour at `brightness` / 256.
ColourTable darker_colours(const Palette& palette, int brightness);

inline constexpr int kGlyphWidth_px = 5, kGlyphHeight_px = 8, kGlyphAdvance_px = 6, kLineHeight_px = 10;
inline constexpr int kAccentRows_px = 2;  ///< above a glyph, between the lines
inline constexpr char kFirstGlyph = ' ';
inline constexpr int kGlyphCount = 95;  ///< ' ' to '~'

/// Rows -2 to 7, top to bottom, the last for descenders; bit 4 is the leftmost of five pixels.
using Glyph = std::array<std::uint8_t, kAccentRows_px + kGlyphHeight_px>;

/// Whether a glyph's pixel is set; `column` from the left.
constexpr bool is_drawn(const Glyph& glyph, int row, int column) {
    return (item(glyph, kAccentRows_px + row) >> (kGlyphWidth_px - 1 - column) & 1) != 0;
}

/// The glyph of a letter of ASCII, Latin-1 or Latin Extended-A, or of a common mark; a question mark for others.
Glyph glyph_of(char32_t letter);

/// Calls draw(column, row) for each pixel of a line's letters, the first letter's upper left corner at (0, 0).
template <class Draw>
void for_each_dot(std::string_view line, Draw draw) {
    for (std::int32_t left = 0; !line.empty(); left += kGlyphAdvance_px) {
        const Glyph glyph = glyph_of(take_letter(line));
        for (int row = -kAccentRows_px; row < kGlyphHeight_px; ++row)
            for (int column = 0; column < kGlyphWidth_px; ++column)
                if (is_drawn(glyph, row, column)) draw(left + column, row);
    }
}

/// The colours and the scale of text.
struct TextColours {
    std::uint8_t bright = 0, dark = 0;
    std::int32_t scale = 1;  ///< pixels for each pixel of a letter, in both directions
};
/// The palette's brightest and darkest colour.
TextColours text_colours_of(const Palette& palette);

/// The scale of text in a canvas: 1 up to less than a quarter more than 320x200, the next integer from there on, and so
/// on; then times the player's choice. It leaves at least 26 columns and 9 lines if possible.
std::int32_t text_scale_in(std::int32_t width_px, std::int32_t height_px, std::int32_t times);

/// The rows, from the bottom of a canvas, that all panels may cover together: a little more than half, or more if there
/// are few lines of text at this scale.
std::int32_t panel_room_px(Framebuffer canvas, std::int32_t scale);

/// Space between text and the sides of the canvas.
inline constexpr std::int32_t kTextMargin_px = 4;

/// The width of a line at scale 1, including its shadow.
std::int32_t text_width_px(std::string_view line);

/// Wraps a text to `width_px` at scale 1, at line feeds and spaces; longer words are cut. Returns at least one line;
/// they refer to the text.
std::vector<std::string_view> lines_of(std::string_view text, std::int32_t width_px);

/// Draws a line with its upper left corner at (x, y), and a dark shadow to the lower right; clipped to the canvas.
void draw_text(Framebuffer canvas, std::int32_t x, std::int32_t y, std::string_view line, TextColours colours);

/// Draws a text from row `y` down, wrapped between the canvas's margins.
void draw_lines(std::int32_t y, std::string_view text, TextColours colours, Framebuffer canvas);
/// The same, ending above row `bottom`. Returns the first row.
std::int32_t draw_lines_above(std::int32_t bottom, std::string_view text, TextColours colours, Framebuffer canvas);

/// The lines of a text wrapped between the canvas's margins.
std::vector<std::string_view> lines_across(std::string_view text, TextColours colours, Framebuffer canvas);

}  // namespace oblong
