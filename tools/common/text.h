#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/screen/screen.h"
#include "engine/surface/palette.h"

namespace oblong {

/// How text is drawn: two colours, and how large.
struct TextColours {
    std::uint8_t bright = 0, dark = 0;
    std::int32_t scale = 1;  ///< columns and rows of pixels for each pixel of a letter
};
/// The palette's brightest and darkest.
TextColours text_colours_of(const Palette& palette);

/// Between text and the sides of the canvas.
inline constexpr std::int32_t kTextMargin_px = 4;

/// How wide a line is at scale 1, its shadow included.
std::int32_t text_width_px(std::string_view line);

/// A text in lines that are no wider than `width_px` at scale 1, broken at its line feeds and at spaces; words wider
/// than that are cut. Never without a line; they live as long as the text.
std::vector<std::string_view> lines_of(std::string_view text, std::int32_t width_px);

/// A line of ASCII whose cells begin at (x, y), with a dark shadow right below; what lies outside the canvas is cut.
void draw_text(Framebuffer canvas, std::int32_t x, std::int32_t y, std::string_view line, TextColours colours);

/// A text from the row `y` down, in lines that fit between the canvas's margins.
void draw_lines(std::int32_t y, std::string_view text, TextColours colours, Framebuffer canvas);
/// The same, but so that it ends above the row `bottom`. The row above which it begins.
std::int32_t draw_lines_above(std::int32_t bottom, std::string_view text, TextColours colours, Framebuffer canvas);

/// How a text is wrapped that is drawn between the canvas's margins.
std::vector<std::string_view> lines_across(std::string_view text, TextColours colours, Framebuffer canvas);

}  // namespace oblong
