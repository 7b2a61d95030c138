#include "tools/gallery/canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/raster/lines.h"

namespace oblong {

namespace {

PixelPosition pixel_at(const Vec& place) {
    return {static_cast<std::int32_t>(std::floor(place.x)), static_cast<std::int32_t>(std::floor(place.y))};
}

}  // namespace

Area Canvas::scene(std::int32_t width_of_320) const {
    return {0, kHeader_px, std::max(width_px * width_of_320 / 320, 8),
            std::max(height_px - kHeader_px - kFooter_px, 8)};
}

void Canvas::enlarge(Framebuffer picture) {
    paint([&](std::int32_t x, std::int32_t y) {
        return picture.row(y * picture.height_px / height_px)[x * picture.width_px / width_px];
    });
}

void Canvas::write(std::int32_t x, std::int32_t y, std::string_view line, Rgb8 colour) {
    draw_text(*this, x, y, line, {input.colour(colour), input.assets.text.dark});
}

void Canvas::column(std::int32_t x, std::int32_t below_px, std::span<const std::string> lines) {
    std::int32_t y = kHeader_px + below_px;
    const auto room = as_size(std::max(height_px - kFooter_px - y, 0) / kLineHeight_px);
    for (std::size_t i = 0; i < std::min(room, lines.size()); ++i, y += kLineHeight_px) {
        const bool is_cut = i + 1 == room && room < lines.size();
        write(x, y, is_cut ? "and " + std::to_string(lines.size() - i) + " more" : lines[i]);
    }
}

void Canvas::note(std::span<const std::string> lines) {
    if (width_px < 320) return;
    std::int32_t wide = 0;
    for (const std::string& line : lines) wide = std::max(wide, text_width_px(line));
    const auto high = static_cast<std::int32_t>(lines.size()) * kLineHeight_px + 5;
    fill_area(*this, {0, kHeader_px, wide + 2 * kTextMargin_px, high}, input.assets.text.dark);
    column(kTextMargin_px, 3, lines);
}

void Canvas::line(const DrawnPoint& from, const DrawnPoint& to, Rgb8 colour) {
    draw_line(pixel_at(pixel_of(from)), pixel_at(pixel_of(to)), {LineMethod::Bresenham, input.colour(colour)}, *this);
}

void Canvas::ellipse(const Vec& middle, const Vec& one, const Vec& other, int parts, Rgb8 colour) {
    const auto at = [&](int part) {
        const double angle = part * 2 * std::numbers::pi / parts;
        return middle + one * std::cos(angle) + other * std::sin(angle);
    };
    curve(parts, at, colour);
}

void Canvas::dot(const DrawnPoint& at, Rgb8 colour) {
    const PixelPosition middle = pixel_at(pixel_of(at));
    box({middle.column - 1, middle.row - 1, 3, 3}, colour);
}

void Canvas::label(const DrawnPoint& at, std::string_view line, Rgb8 colour, std::int32_t right_px,
                   std::int32_t below_px) {
    const Vec place = pixel_of(at);
    write(static_cast<std::int32_t>(place.x) + right_px, static_cast<std::int32_t>(place.y) + below_px, line, colour);
}

Diagram::Diagram(const Canvas& canvas, Vec centre, double units_high) : Canvas(canvas), centre_(centre) {
    const double rows = height_px - kHeader_px - kFooter_px;
    middle_px_ = {width_px / 2.0, kHeader_px + rows / 2};
    px_per_unit_y_ = rows / units_high;
    px_per_unit_x_ = px_per_unit_y_ * number_of(input.mode.pixel().inverse());
}

Vec Diagram::pixel_of(const Vec& point) const {
    return {middle_px_.x + (point.x - centre_.x) * px_per_unit_x_,
            middle_px_.y - (point.y - centre_.y) * px_per_unit_y_};
}

void Diagram::arrow(const Vec& from, const Vec& to, Rgb8 colour) {
    line(from, to, colour);
    constexpr double kHead_px = 6;
    const Vec back = from - to;
    const double length = std::hypot(back.x, back.y);
    if (length == 0) return;
    const double along = kHead_px / px_per_unit_y_ / length;
    for (const double side : {-0.5, 0.5})
        line(to, to + Vec{back.x - side * back.y, back.y + side * back.x} * along, colour);
}

void Diagram::disc(const Vec& centre, double radius, Rgb8 colour) {
    const Vec middle = pixel_of(centre);
    const double across = radius * px_per_unit_x_, down = radius * px_per_unit_y_;
    const std::uint8_t index = input.colour(colour);
    for (auto y = static_cast<std::int32_t>(middle.y - down); y <= middle.y + down; ++y)
        for (auto x = static_cast<std::int32_t>(middle.x - across); x <= middle.x + across; ++x)
            if (std::hypot((x + 0.5 - middle.x) / across, (y + 0.5 - middle.y) / down) <= 1)
                set_pixel(*this, x, y, index);
}

void Diagram::rectangle(const Vec& lowest, const Vec& highest, Rgb8 colour) {
    const Vec a = pixel_of({lowest.x, highest.y}), b = pixel_of({highest.x, lowest.y});
    const auto rounded = [](double place) { return static_cast<std::int32_t>(std::lround(place)); };
    box({rounded(a.x), rounded(a.y), rounded(b.x) - rounded(a.x), rounded(b.y) - rounded(a.y)}, colour);
}

PixelGrid::PixelGrid(const Canvas& canvas, const Area& place, std::int32_t columns, std::int32_t rows, Rgb8 background)
    : Canvas(canvas), picture(columns, rows, input.colour(background)) {
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

void PixelGrid::show() {
    box(area_, kNight);
    const std::int32_t right = block_width_ > 2, down = block_height_ > 2;
    for (std::int32_t y = 0; y < picture.height_px; ++y)
        for (std::int32_t x = 0; x < picture.width_px; ++x) {
            const Vec corner = pixel_of({double(x), double(y)});
            fill_area(*this,
                      {static_cast<std::int32_t>(corner.x), static_cast<std::int32_t>(corner.y), block_width_ - right,
                       block_height_ - down},
                      picture.row(y)[x]);
        }
}

Vec PixelGrid::pixel_of(const Vec& point) const {
    return {area_.x + point.x * block_width_, area_.y + point.y * block_height_};
}

}  // namespace oblong
