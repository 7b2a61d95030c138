#include "tools/gallery/diagram.h"

#include <algorithm>
#include <cmath>

#include "engine/draw/drawing.h"
#include "engine/raster/lines.h"

namespace oblong {

Diagram::Diagram(const RowInput& input, Framebuffer canvas, PlanePoint centre, double units_high)
    : canvas_(canvas), text_(input.assets.text), centre_(centre) {
    const double rows = canvas.height_px - kHeader_px - kFooter_px;
    middle_px_ = {canvas.width_px / 2.0, kHeader_px + rows / 2};
    px_per_unit_y_ = rows / units_high;
    px_per_unit_x_ = px_per_unit_y_ * number_of(input.mode.pixel().inverse());
}

PlanePoint Diagram::on_canvas(PlanePoint at) const {
    return {middle_px_.x + (at.x - centre_.x) * px_per_unit_x_, middle_px_.y - (at.y - centre_.y) * px_per_unit_y_};
}

void Diagram::fill(std::uint8_t colour) {
    oblong::fill(canvas_, colour);
}

void Diagram::line(PlanePoint from, PlanePoint to, std::uint8_t colour) {
    const auto pixel = [&](PlanePoint at) {
        const PlanePoint place = on_canvas(at);
        return PixelPosition{static_cast<std::int32_t>(std::floor(place.x)),
                             static_cast<std::int32_t>(std::floor(place.y))};
    };
    draw_line(pixel(from), pixel(to), {LineMethod::Bresenham, colour}, canvas_);
}

void Diagram::arrow(PlanePoint from, PlanePoint to, std::uint8_t colour) {
    line(from, to, colour);
    constexpr double kHead_px = 6;
    const double x = from.x - to.x, y = from.y - to.y, length = std::hypot(x, y);
    if (length == 0) return;
    const double along = kHead_px / px_per_unit_y_ / length;
    for (const double side : {-0.5, 0.5})
        line(to, {to.x + (x - side * y) * along, to.y + (y + side * x) * along}, colour);
}

void Diagram::circle(PlanePoint centre, double radius, std::uint8_t colour) {
    constexpr int kCorners = 96;
    const auto at = [&](int corner) {
        const double angle = corner * 2 * std::numbers::pi / kCorners;
        return PlanePoint{centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
    };
    curve(kCorners, at, colour);
}

void Diagram::disc(PlanePoint centre, double radius, std::uint8_t colour) {
    const PlanePoint middle = on_canvas(centre);
    const double across = radius * px_per_unit_x_, down = radius * px_per_unit_y_;
    for (auto y = static_cast<std::int32_t>(middle.y - down); y <= middle.y + down; ++y)
        for (auto x = static_cast<std::int32_t>(middle.x - across); x <= middle.x + across; ++x)
            if (std::hypot((x + 0.5 - middle.x) / across, (y + 0.5 - middle.y) / down) <= 1)
                set_pixel(canvas_, x, y, colour);
}

void Diagram::rectangle(PlanePoint lowest, PlanePoint highest, std::uint8_t colour) {
    const PlanePoint a = on_canvas({lowest.x, highest.y}), b = on_canvas({highest.x, lowest.y});
    const auto x = static_cast<std::int32_t>(std::lround(a.x)), y = static_cast<std::int32_t>(std::lround(a.y));
    fill_area(canvas_,
              {x, y, static_cast<std::int32_t>(std::lround(b.x)) - x, static_cast<std::int32_t>(std::lround(b.y)) - y},
              colour);
}

void Diagram::text(PlanePoint at, std::string_view line, std::uint8_t colour, std::int32_t right_px,
                   std::int32_t below_px) {
    const PlanePoint place = on_canvas(at);
    draw_text(canvas_, static_cast<std::int32_t>(place.x) + right_px, static_cast<std::int32_t>(place.y) + below_px,
              line, {colour, text_.dark});
}

PixelGrid::PixelGrid(const RowInput& input, Framebuffer canvas, const Area& place, std::int32_t columns,
                     std::int32_t rows, std::uint8_t background)
    : canvas_(canvas), columns_(columns), rows_(rows), pixels_(pixel_count(columns, rows), background) {
    const double shape = number_of(input.mode.pixel());
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
