#include "engine/draw/drawing.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/surface/palette.h"

namespace oblong {
namespace {

// Drawn for Oblong. A row is five bits, the leftmost pixel highest.
// clang-format off
constexpr std::array<Glyph, kGlyphCount> kGlyphs{{
    {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000},  // space
    {0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00000, 0b00100, 0b00000},  // !
    {0b01010, 0b01010, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000},  // "
    {0b01010, 0b11111, 0b01010, 0b01010, 0b01010, 0b11111, 0b01010, 0b00000},  // #
    {0b00100, 0b01111, 0b10100, 0b01110, 0b00101, 0b11110, 0b00100, 0b00000},  // $
    {0b11001, 0b11010, 0b00100, 0b00100, 0b00100, 0b01011, 0b10011, 0b00000},  // %
    {0b01100, 0b10010, 0b01100, 0b01101, 0b10010, 0b10010, 0b01101, 0b00000},  // &
    {0b00100, 0b00100, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000},  // '
    {0b00010, 0b00100, 0b01000, 0b01000, 0b01000, 0b00100, 0b00010, 0b00000},  // (
    {0b01000, 0b00100, 0b00010, 0b00010, 0b00010, 0b00100, 0b01000, 0b00000},  // )
    {0b00000, 0b10101, 0b01110, 0b11111, 0b01110, 0b10101, 0b00000, 0b00000},  // *
    {0b00000, 0b00100, 0b00100, 0b11111, 0b00100, 0b00100, 0b00000, 0b00000},  // +
    {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b00100, 0b00100, 0b01000},  // ,
    {0b00000, 0b00000, 0b00000, 0b01110, 0b00000, 0b00000, 0b00000, 0b00000},  // -
    {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b01100, 0b01100, 0b00000},  // .
    {0b00001, 0b00010, 0b00010, 0b00100, 0b01000, 0b01000, 0b10000, 0b00000},  // /
    {0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110, 0b00000},  // 0
    {0b00100, 0b01100, 0b10100, 0b00100, 0b00100, 0b00100, 0b11111, 0b00000},  // 1
    {0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111, 0b00000},  // 2
    {0b11110, 0b00001, 0b00001, 0b01110, 0b00001, 0b00001, 0b11110, 0b00000},  // 3
    {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010, 0b00000},  // 4
    {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110, 0b00000},  // 5
    {0b01110, 0b10000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110, 0b00000},  // 6
    {0b11111, 0b00001, 0b00010, 0b00010, 0b00100, 0b00100, 0b00100, 0b00000},  // 7
    {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110, 0b00000},  // 8
    {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00001, 0b01110, 0b00000},  // 9
    {0b00000, 0b01100, 0b01100, 0b00000, 0b01100, 0b01100, 0b00000, 0b00000},  // :
    {0b00000, 0b00000, 0b01100, 0b01100, 0b00000, 0b01100, 0b00100, 0b01000},  // ;
    {0b00001, 0b00110, 0b11000, 0b10000, 0b11000, 0b00110, 0b00001, 0b00000},  // <
    {0b00000, 0b00000, 0b11111, 0b00000, 0b11111, 0b00000, 0b00000, 0b00000},  // =
    {0b10000, 0b01000, 0b00100, 0b00010, 0b00100, 0b01000, 0b10000, 0b00000},  // >
    {0b01110, 0b10001, 0b00001, 0b00010, 0b00100, 0b00000, 0b00100, 0b00000},  // ?
    {0b01110, 0b10001, 0b10111, 0b10101, 0b10111, 0b10000, 0b01110, 0b00000},  // @
    {0b01110, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001, 0b00000},  // A
    {0b11110, 0b10001, 0b10001, 0b11110, 0b10001, 0b10001, 0b11110, 0b00000},  // B
    {0b01110, 0b10001, 0b10000, 0b10000, 0b10000, 0b10001, 0b01110, 0b00000},  // C
    {0b11110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b11110, 0b00000},  // D
    {0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b11111, 0b00000},  // E
    {0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b10000, 0b00000},  // F
    {0b01110, 0b10001, 0b10000, 0b10111, 0b10001, 0b10001, 0b01111, 0b00000},  // G
    {0b10001, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001, 0b00000},  // H
    {0b01110, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110, 0b00000},  // I
    {0b00111, 0b00001, 0b00001, 0b00001, 0b00001, 0b10001, 0b01110, 0b00000},  // J
    {0b10001, 0b10010, 0b10100, 0b11000, 0b10100, 0b10010, 0b10001, 0b00000},  // K
    {0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b11111, 0b00000},  // L
    {0b10001, 0b11011, 0b10101, 0b10101, 0b10001, 0b10001, 0b10001, 0b00000},  // M
    {0b10001, 0b11001, 0b10101, 0b10011, 0b10001, 0b10001, 0b10001, 0b00000},  // N
    {0b01110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110, 0b00000},  // O
    {0b11110, 0b10001, 0b10001, 0b11110, 0b10000, 0b10000, 0b10000, 0b00000},  // P
    {0b01110, 0b10001, 0b10001, 0b10001, 0b10101, 0b10010, 0b01101, 0b00000},  // Q
    {0b11110, 0b10001, 0b10001, 0b11110, 0b10100, 0b10010, 0b10001, 0b00000},  // R
    {0b01111, 0b10000, 0b10000, 0b01110, 0b00001, 0b00001, 0b11110, 0b00000},  // S
    {0b11111, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00000},  // T
    {0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110, 0b00000},  // U
    {0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01010, 0b00100, 0b00000},  // V
    {0b10001, 0b10001, 0b10001, 0b10101, 0b10101, 0b11011, 0b10001, 0b00000},  // W
    {0b10001, 0b10001, 0b01010, 0b00100, 0b01010, 0b10001, 0b10001, 0b00000},  // X
    {0b10001, 0b10001, 0b01010, 0b00100, 0b00100, 0b00100, 0b00100, 0b00000},  // Y
    {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b10000, 0b11111, 0b00000},  // Z
    {0b01110, 0b01000, 0b01000, 0b01000, 0b01000, 0b01000, 0b01110, 0b00000},  // [
    {0b10000, 0b01000, 0b01000, 0b00100, 0b00010, 0b00010, 0b00001, 0b00000},  // backslash
    {0b01110, 0b00010, 0b00010, 0b00010, 0b00010, 0b00010, 0b01110, 0b00000},  // ]
    {0b00100, 0b01010, 0b10001, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000},  // ^
    {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b11111},  // _
    {0b01000, 0b00100, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000},  // `
    {0b00000, 0b00000, 0b01110, 0b00001, 0b01111, 0b10001, 0b01111, 0b00000},  // a
    {0b10000, 0b10000, 0b11110, 0b10001, 0b10001, 0b10001, 0b11110, 0b00000},  // b
    {0b00000, 0b00000, 0b01111, 0b10000, 0b10000, 0b10000, 0b01111, 0b00000},  // c
    {0b00001, 0b00001, 0b01111, 0b10001, 0b10001, 0b10001, 0b01111, 0b00000},  // d
    {0b00000, 0b00000, 0b01110, 0b10001, 0b11111, 0b10000, 0b01110, 0b00000},  // e
    {0b00110, 0b01000, 0b11110, 0b01000, 0b01000, 0b01000, 0b01000, 0b00000},  // f
    {0b00000, 0b00000, 0b01111, 0b10001, 0b10001, 0b01111, 0b00001, 0b01110},  // g
    {0b10000, 0b10000, 0b11110, 0b10001, 0b10001, 0b10001, 0b10001, 0b00000},  // h
    {0b00100, 0b00000, 0b01100, 0b00100, 0b00100, 0b00100, 0b01110, 0b00000},  // i
    {0b00000, 0b00010, 0b00000, 0b00110, 0b00010, 0b00010, 0b00010, 0b01100},  // j
    {0b10000, 0b10000, 0b10010, 0b10100, 0b11000, 0b10100, 0b10010, 0b00000},  // k
    {0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110, 0b00000},  // l
    {0b00000, 0b00000, 0b11010, 0b10101, 0b10101, 0b10101, 0b10101, 0b00000},  // m
    {0b00000, 0b00000, 0b11110, 0b10001, 0b10001, 0b10001, 0b10001, 0b00000},  // n
    {0b00000, 0b00000, 0b01110, 0b10001, 0b10001, 0b10001, 0b01110, 0b00000},  // o
    {0b00000, 0b00000, 0b11110, 0b10001, 0b10001, 0b11110, 0b10000, 0b10000},  // p
    {0b00000, 0b00000, 0b01111, 0b10001, 0b10001, 0b01111, 0b00001, 0b00001},  // q
    {0b00000, 0b00000, 0b10110, 0b11000, 0b10000, 0b10000, 0b10000, 0b00000},  // r
    {0b00000, 0b00000, 0b01111, 0b10000, 0b01110, 0b00001, 0b11110, 0b00000},  // s
    {0b01000, 0b01000, 0b11110, 0b01000, 0b01000, 0b01000, 0b00110, 0b00000},  // t
    {0b00000, 0b00000, 0b10001, 0b10001, 0b10001, 0b10001, 0b01111, 0b00000},  // u
    {0b00000, 0b00000, 0b10001, 0b10001, 0b01010, 0b01010, 0b00100, 0b00000},  // v
    {0b00000, 0b00000, 0b10001, 0b10101, 0b10101, 0b10101, 0b01010, 0b00000},  // w
    {0b00000, 0b00000, 0b10001, 0b01010, 0b00100, 0b01010, 0b10001, 0b00000},  // x
    {0b00000, 0b00000, 0b10001, 0b10001, 0b10001, 0b01111, 0b00001, 0b01110},  // y
    {0b00000, 0b00000, 0b11111, 0b00010, 0b00100, 0b01000, 0b11111, 0b00000},  // z
    {0b00011, 0b00100, 0b00100, 0b01000, 0b00100, 0b00100, 0b00011, 0b00000},  // {
    {0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00000},  // |
    {0b11000, 0b00100, 0b00100, 0b00010, 0b00100, 0b00100, 0b11000, 0b00000},  // }
    {0b00000, 0b00000, 0b01001, 0b10101, 0b10010, 0b00000, 0b00000, 0b00000},  // ~
}};
// clang-format on

void draw_glyph(Framebuffer canvas, std::int32_t x, std::int32_t y, const Glyph& glyph, std::uint8_t colour,
                std::int32_t scale) {
    for (std::int32_t row = 0; row < kGlyphHeight_px; ++row)
        for (std::int32_t column = 0; column < kGlyphWidth_px; ++column)
            if (is_drawn(glyph, row, column))
                fill_area(canvas, {x + column * scale, y + row * scale, scale, scale}, colour);
}

void draw_plain(Framebuffer canvas, std::int32_t x, std::int32_t y, std::string_view line, std::uint8_t colour,
                std::int32_t scale) {
    for (const char character : line) {
        draw_glyph(canvas, x, y, glyph_of(character), colour, scale);
        x += kGlyphAdvance_px * scale;
    }
}

}  // namespace

Area clipped(const Area& area, Framebuffer canvas) {
    const std::int32_t left = std::clamp(area.x, 0, canvas.width_px), top = std::clamp(area.y, 0, canvas.height_px);
    const std::int32_t right = std::clamp(area.x + area.width, left, canvas.width_px);
    const std::int32_t bottom = std::clamp(area.y + area.height, top, canvas.height_px);
    return {left, top, right - left, bottom - top};
}

Framebuffer part_of(Framebuffer canvas, const Area& area) {
    const Area part = clipped(area, canvas);
    return {canvas.row(part.y) + part.x, part.width, part.height, canvas.pitch};
}

void set_pixel(Framebuffer canvas, std::int32_t x, std::int32_t y, std::uint8_t colour) {
    if (x >= 0 && x < canvas.width_px && y >= 0 && y < canvas.height_px) canvas.row(y)[x] = colour;
}

void fill_area(Framebuffer canvas, const Area& area, std::uint8_t colour) {
    const Framebuffer part = part_of(canvas, area);
    for (std::int32_t row = 0; row < part.height_px; ++row) std::fill_n(part.row(row), part.width_px, colour);
}

void recolour_area(Framebuffer canvas, const Area& area, const ColourTable& table) {
    const Framebuffer part = part_of(canvas, area);
    for (std::int32_t row = 0; row < part.height_px; ++row)
        std::transform(part.row(row), part.row(row) + part.width_px, part.row(row),
                       [&](std::uint8_t colour) { return table[colour]; });
}

ColourTable darker_colours(const Palette& palette, int brightness) {
    const auto darker = [=](std::uint8_t channel) { return static_cast<std::uint8_t>(channel * brightness / 256); };
    ColourTable table;
    std::transform(palette.colours.begin(), palette.colours.end(), table.begin(), [&](Rgb8 colour) {
        return nearest_colour(palette, {darker(colour.red), darker(colour.green), darker(colour.blue)});
    });
    return table;
}

const Glyph& glyph_of(char character) {
    const auto index = static_cast<unsigned char>(character) - std::size_t{kFirstGlyph};
    return kGlyphs[index < kGlyphs.size() ? index : '?' - std::size_t{kFirstGlyph}];
}

TextColours text_colours_of(const Palette& palette) {
    const auto [dark, bright] = std::minmax_element(palette.colours.begin(), palette.colours.end(), [](Rgb8 a, Rgb8 b) {
        return luminance_1000(a) < luminance_1000(b);
    });
    return {static_cast<std::uint8_t>(bright - palette.colours.begin()),
            static_cast<std::uint8_t>(dark - palette.colours.begin())};
}

std::int32_t text_scale_in(std::int32_t width_px, std::int32_t height_px, std::int32_t times) {
    constexpr std::int32_t kFewestColumns = 26, kFewestLines = 9;
    const std::int32_t quarters = std::min(width_px * 4 / 320, height_px * 4 / 200);
    const std::int32_t most =
        std::min(width_px / (kFewestColumns * kGlyphAdvance_px), height_px / (kFewestLines * kLineHeight_px));
    return std::max(std::min(std::max((quarters + 3) / 4, 1) * times, most), 1);
}

std::int32_t panel_room_px(Framebuffer canvas, std::int32_t scale) {
    constexpr std::int32_t kManyLines = 18;
    const bool has_many = canvas.height_px / (kLineHeight_px * scale) >= kManyLines;
    return has_many ? canvas.height_px * 23 / 40 : canvas.height_px * 4 / 5;
}

std::int32_t text_width_px(std::string_view line) {
    return static_cast<std::int32_t>(line.size()) * kGlyphAdvance_px;
}

std::vector<std::string_view> lines_of(std::string_view text, std::int32_t width_px) {
    const auto most = as_size(std::max(width_px / kGlyphAdvance_px, 1));
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
    draw_plain(canvas, x + colours.scale, y + colours.scale, line, colours.dark, colours.scale);
    draw_plain(canvas, x, y, line, colours.bright, colours.scale);
}

std::vector<std::string_view> lines_across(std::string_view text, TextColours colours, Framebuffer canvas) {
    return lines_of(text, (canvas.width_px - 2 * kTextMargin_px) / colours.scale);
}

void draw_lines(std::int32_t y, std::string_view text, TextColours colours, Framebuffer canvas) {
    for (const std::string_view line : lines_across(text, colours, canvas)) {
        draw_text(canvas, kTextMargin_px, y, line, colours);
        y += kLineHeight_px * colours.scale;
    }
}

std::int32_t draw_lines_above(std::int32_t bottom, std::string_view text, TextColours colours, Framebuffer canvas) {
    const std::size_t count = lines_across(text, colours, canvas).size();
    const std::int32_t top = bottom - static_cast<std::int32_t>(count) * kLineHeight_px * colours.scale;
    draw_lines(top, text, colours, canvas);
    return top;
}

}  // namespace oblong
