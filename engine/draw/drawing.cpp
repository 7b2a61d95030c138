#include "engine/draw/drawing.h"

#include <algorithm>

#include "engine/surface/nearest_colour.h"

namespace oblong {

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

}  // namespace oblong
