#include "engine/draw/drawing.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/surface/palette.h"

namespace oblong {
namespace {

void draw_plain(Framebuffer canvas, std::int32_t x, std::int32_t y, std::string_view line, std::uint8_t colour,
                std::int32_t scale) {
    if (scale == 1)  // a third of the work
        return for_each_dot(
            line, [&](std::int32_t column, std::int32_t row) { set_pixel(canvas, x + column, y + row, colour); });
    for_each_dot(line, [&](std::int32_t column, std::int32_t row) {
        fill_area(canvas, {x + column * scale, y + row * scale, scale, scale}, colour);
    });
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
    if (part.width == 0 || part.height == 0) return {canvas.pixels, 0, 0, canvas.pitch};
    return {canvas.row(part.y) + part.x, part.width, part.height, canvas.pitch};
}

void set_pixel(Framebuffer canvas, std::int32_t x, std::int32_t y, std::uint8_t colour) {
    if (x >= 0 && x < canvas.width_px && y >= 0 && y < canvas.height_px) canvas.row(y)[x] = colour;
}

void fill_area(Framebuffer canvas, const Area& area, std::uint8_t colour) {
    const Framebuffer part = part_of(canvas, area);
    for (std::int32_t row = 0; row < part.height_px; ++row) std::fill_n(part.row(row), part.width_px, colour);
}

void draw_border(Framebuffer canvas, const Area& area, std::uint8_t colour) {
    if (area.width <= 0 || area.height <= 0) return;
    for (const Area& side :
         {Area{area.x, area.y, area.width, 1}, Area{area.x, area.y + area.height - 1, area.width, 1},
          Area{area.x, area.y, 1, area.height}, Area{area.x + area.width - 1, area.y, 1, area.height}})
        fill_area(canvas, side, colour);
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
    return static_cast<std::int32_t>(letters_in(line)) * kGlyphAdvance_px;
}

std::vector<std::string_view> lines_of(std::string_view text, std::int32_t width_px) {
    const auto most = as_size(std::max(width_px / kGlyphAdvance_px, 1));
    std::vector<std::string_view> lines;
    do {
        std::string_view line = first_letters(text.substr(0, text.find('\n')), most + 1);
        const std::size_t fit = first_letters(line, most).size();
        if (line.size() > fit) line = line.substr(0, std::min(line.rfind(' '), fit));
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
