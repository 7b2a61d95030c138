#include "game/menu/menu_look.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/draw/text.h"
#include "engine/surface/palette.h"

namespace oblong {
namespace {

constexpr int kVeilBrightness = 104;  // of 256
constexpr std::array<Rgb8, kLetteringRamp> kRamp{
    {{255, 240, 192}, {255, 220, 136}, {248, 192, 88}, {232, 156, 56}, {204, 116, 36}, {164, 80, 24}, {120, 52, 16}}};
constexpr Rgb8 kPlain{208, 196, 176}, kDim{152, 140, 120}, kBar{104, 56, 20}, kEdge{232, 156, 56};

// One cell with a bright upper edge. From 4 pixels on, it leaves a gap to the next cell.
void draw_cell(Framebuffer canvas, std::int32_t x, std::int32_t y, LetterCell cell, std::uint8_t colour,
               std::uint8_t lit) {
    const std::int32_t gap_x = cell.width_px >= 4, gap_y = cell.height_px >= 4;
    fill_area(canvas, {x, y, cell.width_px - gap_x, cell.height_px - gap_y}, colour);
    if (gap_y != 0) fill_area(canvas, {x, y, cell.width_px - gap_x, 1}, lit);
}

template <class DrawCell>
void for_each_cell(std::string_view line, LetterCell cell, DrawCell draw) {
    std::int32_t left = 0;
    for (const char letter : line) {
        const Glyph& glyph = glyph_of(letter);
        for (int row = 0; row < kGlyphHeight_px; ++row)
            for (int column = 0; column < kGlyphWidth_px; ++column)
                if (is_drawn(glyph, row, column)) draw(left + column * cell.width_px, row * cell.height_px, row);
        left += kGlyphAdvance_px * cell.width_px;
    }
}

}  // namespace

MenuLook::MenuLook(const Palette& palette)
    : text(text_colours_of(palette)),
      plain(nearest_colour(palette, kPlain)),
      dim(nearest_colour(palette, kDim)),
      bar(nearest_colour(palette, kBar)),
      edge(nearest_colour(palette, kEdge)),
      veil(darker_colours(palette, kVeilBrightness)) {
    std::transform(kRamp.begin(), kRamp.end(), ramp.begin(), [&](Rgb8 rgb) { return nearest_colour(palette, rgb); });
}

Area lettering_size(std::string_view line, LetterCell cell) {
    const auto columns = static_cast<std::int32_t>(line.size()) * kGlyphAdvance_px - 1;
    return {0, 0, std::max(columns, 0) * cell.width_px, kLetteringRamp * cell.height_px};
}

void draw_lettering(Framebuffer canvas, std::int32_t x, std::int32_t y, std::string_view line, LetterCell cell,
                    const MenuLook& look) {
    const std::int32_t shadow_x = std::max(cell.width_px / 2, 1), shadow_y = std::max(cell.height_px / 2, 1);
    for_each_cell(line, cell, [&](std::int32_t left, std::int32_t top, int) {
        fill_area(canvas, {x + left + shadow_x, y + top + shadow_y, cell.width_px, cell.height_px}, look.text.dark);
    });
    for_each_cell(line, cell, [&](std::int32_t left, std::int32_t top, int row) {
        const std::uint8_t colour = item(look.ramp, std::min(row, kLetteringRamp - 1));
        draw_cell(canvas, x + left, y + top, cell, colour, item(look.ramp, std::clamp(row - 2, 0, kLetteringRamp - 1)));
    });
}

}  // namespace oblong
