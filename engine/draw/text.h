#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/surface/palette.h"
#include "engine/view/screen.h"

namespace oblong {

/// How text is drawn: two colours, and how large.
struct TextColours {
    std::uint8_t bright = 0, dark = 0;
    std::int32_t scale = 1;  ///< columns and rows of pixels for each pixel of a letter
};
/// The palette's brightest and darkest.
TextColours text_colours_of(const Palette& palette);

/// How large text is drawn in a canvas: as seen in 320x200, from a quarter more columns and rows on the next larger,
/// times the player's choice; no larger than leaves 26 columns and 9 lines, where there are as many.
std::int32_t text_scale_in(std::int32_t width_px, std::int32_t height_px, std::int32_t times);

/// The rows of a canvas, counted from its bottom, that panels over its picture may take together: a little more than
/// half, and more where letters of that scale leave few lines.
std::int32_t panel_room_px(Framebuffer canvas, std::int32_t scale);

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
