#include "game/text.h"

#include <algorithm>

#include "tools/common/font.h"

namespace oblong {
namespace {

constexpr std::int32_t kPanelMargin_px = 6;

// ITU-R BT.601's weights for red, green and blue, in thousandths.
int luminance(Rgb8 colour) {
    return 299 * colour.red + 587 * colour.green + 114 * colour.blue;
}

void put(Framebuffer canvas, std::int32_t x, std::int32_t y, std::uint8_t colour) {
    if (x >= 0 && x < canvas.width_px && y >= 0 && y < canvas.height_px) canvas.row(y)[x] = colour;
}

void draw_glyph(Framebuffer canvas, std::int32_t x, std::int32_t y, const Glyph& glyph, std::uint8_t colour) {
    for (std::int32_t row = 0; row < kGlyphHeight_px; ++row)
        for (std::int32_t column = 0; column < kGlyphWidth_px; ++column)
            if (is_drawn(glyph, row, column)) put(canvas, x + column, y + row, colour);
}

void draw_plain(Framebuffer canvas, std::int32_t x, std::int32_t y, std::string_view line, std::uint8_t colour) {
    for (const char character : line) {
        draw_glyph(canvas, x, y, glyph_of(character), colour);
        x += kGlyphAdvance_px;
    }
}

void fill(Framebuffer canvas, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
          std::uint8_t colour) {
    for (std::int32_t row = y; row < y + height; ++row)
        for (std::int32_t column = x; column < x + width; ++column) put(canvas, column, row, colour);
}

}  // namespace

TextColours text_colours_of(const Palette& palette) {
    const auto [dark, bright] = std::minmax_element(palette.colours.begin(), palette.colours.end(),
                                                    [](Rgb8 a, Rgb8 b) { return luminance(a) < luminance(b); });
    return {static_cast<std::uint8_t>(bright - palette.colours.begin()),
            static_cast<std::uint8_t>(dark - palette.colours.begin())};
}

std::int32_t text_width_px(std::string_view line) {
    return static_cast<std::int32_t>(line.size()) * kGlyphAdvance_px;
}

std::vector<std::string_view> lines_of(std::string_view text, std::int32_t width_px) {
    const auto most = static_cast<std::size_t>(std::max(width_px / kGlyphAdvance_px, 1));
    std::vector<std::string_view> lines;
    do {
        std::string_view line = text.substr(0, std::min(text.find('\n'), most + 1));
        if (line.size() > most) line = line.substr(0, std::min(line.rfind(' '), most));
        lines.push_back(line);
        text.remove_prefix(line.size());
        if (!text.empty() && (text.front() == ' ' || text.front() == '\n')) text.remove_prefix(1);
    } while (!text.empty());
    return lines;
}

void draw_text(Framebuffer canvas, std::int32_t x, std::int32_t y, std::string_view line, TextColours colours) {
    draw_plain(canvas, x + 1, y + 1, line, colours.dark);
    draw_plain(canvas, x, y, line, colours.bright);
}

void draw_panel(Framebuffer canvas, std::span<const std::string_view> lines, TextColours colours) {
    std::int32_t width = 0;
    for (const std::string_view line : lines) width = std::max(width, text_width_px(line));
    const auto height = static_cast<std::int32_t>(lines.size()) * kLineHeight_px;
    const std::int32_t x = (canvas.width_px - width) / 2, y = (canvas.height_px - height) / 2;
    fill(canvas, x - kPanelMargin_px, y - kPanelMargin_px, width + 2 * kPanelMargin_px, height + 2 * kPanelMargin_px,
         colours.dark);
    for (std::size_t i = 0; i < lines.size(); ++i)
        draw_plain(canvas, x, y + static_cast<std::int32_t>(i) * kLineHeight_px, lines[i], colours.bright);
}

}  // namespace oblong
