#include "tools/gallery/pixel_grid.h"

#include <algorithm>
#include <cmath>

#include "engine/raster/lines.h"

namespace oblong {

PixelGrid::PixelGrid(const RowInput& input, Framebuffer canvas, const Area& place, std::int32_t columns,
                     std::int32_t rows, std::uint8_t background)
    : canvas_(canvas), columns_(columns), rows_(rows), pixels_(pixel_count(columns, rows), background) {
    const Ratio pixel = input.mode.pixel();
    const double shape = static_cast<double>(pixel.numerator) / static_cast<double>(pixel.denominator);
    for (std::int32_t width = 1;; ++width) {
        const auto height = std::max(static_cast<std::int32_t>(std::lround(width * shape)), 1);
        if (width * columns > place.width || height * rows > place.height) break;
        block_width_ = width;
        block_height_ = height;
    }
    const std::int32_t across = block_width_ * columns, down = block_height_ * rows;
    area_ = {place.x + (place.width - across) / 2, place.y + (place.height - down) / 2, across, down};
}

void PixelGrid::show(std::uint8_t gap) {
    fill_area(canvas_, area_, gap);
    const std::int32_t right = block_width_ > 2, down = block_height_ > 2;
    for (std::int32_t y = 0; y < rows_; ++y)
        for (std::int32_t x = 0; x < columns_; ++x)
            fill_area(
                canvas_,
                {area_.x + x * block_width_, area_.y + y * block_height_, block_width_ - right, block_height_ - down},
                picture().row(y)[x]);
}

PixelPosition PixelGrid::on_canvas(PlanePoint at) const {
    return {area_.x + static_cast<std::int32_t>(std::floor(at.x * block_width_)),
            area_.y + static_cast<std::int32_t>(std::floor(at.y * block_height_))};
}

void PixelGrid::line(PlanePoint from, PlanePoint to, std::uint8_t colour) const {
    draw_line(on_canvas(from), on_canvas(to), {LineMethod::Bresenham, colour}, canvas_);
}

void PixelGrid::dot(PlanePoint at, std::uint8_t colour) const {
    const PixelPosition middle = on_canvas(at);
    fill_area(canvas_, {middle.column - 1, middle.row - 1, 3, 3}, colour);
}

}  // namespace oblong
