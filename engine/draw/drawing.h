#pragma once

#include <array>
#include <cstdint>

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
/// Maps colours to colours.
using ColourTable = std::array<std::uint8_t, 256>;
/// Replaces each colour by its entry in a table.
void recolour_area(Framebuffer canvas, const Area& area, const ColourTable& table);

/// Maps each colour to the palette's nearest colour at `brightness` / 256.
ColourTable darker_colours(const Palette& palette, int brightness);

}  // namespace oblong
