#pragma once

#include <array>
#include <cstdint>

#include "engine/surface/palette.h"
#include "engine/view/screen.h"

namespace oblong {

/// Columns [x, x + width) of rows [y, y + height) of a canvas; perhaps partly outside it.
struct Area {
    std::int32_t x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Area&) const = default;
};

/// The part of an area that is in the canvas.
Area clipped(const Area& area, Framebuffer canvas);
/// The part of a canvas that is in an area, as a canvas of its own.
Framebuffer part_of(Framebuffer canvas, const Area& area);

/// Sets a pixel; one outside the canvas is left out. So are those of the functions below.
void set_pixel(Framebuffer canvas, std::int32_t x, std::int32_t y, std::uint8_t colour);
void fill_area(Framebuffer canvas, const Area& area, std::uint8_t colour);
/// A colour for each colour.
using ColourTable = std::array<std::uint8_t, 256>;
/// Replaces what is there by its entries in a table.
void recolour_area(Framebuffer canvas, const Area& area, const ColourTable& table);

/// The palette's colours nearest to its own at `brightness` of 256.
ColourTable darker_colours(const Palette& palette, int brightness);

}  // namespace oblong
