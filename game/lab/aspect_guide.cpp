#include "game/lab/aspect_guide.h"

#include <algorithm>
#include <cmath>

namespace oblong {
namespace {

// Of the picture's shorter side, as its display shows it.
constexpr double kCircle = 0.54, kSquare = 0.62;

// A pixel's width and height in one unit of length.
struct PixelSize {
    double width, height;
};

PixelSize pixel_size(const ScreenMode& mode) {
    const Ratio pixel = mode.pixel();
    return {static_cast<double>(pixel.numerator), static_cast<double>(pixel.denominator)};
}

double shorter_side(const ScreenMode& mode) {
    const PixelSize pixel = pixel_size(mode);
    return std::min(mode.width_px * pixel.width, mode.height_px * pixel.height);
}

std::int64_t percent_less(std::int64_t shorter, std::int64_t longer) {
    return (200 * (longer - shorter) + longer) / (2 * longer);
}

std::string name_of(ShownAs shown_as, const ScreenMode& mode) {
    if (shown_as == ShownAs::OnDisplay) return "on " + display_name(mode);
    return shown_as == ShownAs::SquarePixels ? "with square pixels" : "in the window's shape";
}

void draw_frame_of(const Area& area, std::uint8_t colour, Framebuffer canvas) {
    fill_area(canvas, {area.x, area.y, area.width, 1}, colour);
    fill_area(canvas, {area.x, area.y + area.height - 1, area.width, 1}, colour);
    fill_area(canvas, {area.x, area.y, 1, area.height}, colour);
    fill_area(canvas, {area.x + area.width - 1, area.y, 1, area.height}, colour);
}

}  // namespace

Ratio shown_pixel(const PresentRect& shown, const ScreenMode& mode) {
    if (shown.width_px <= 0 || shown.height_px <= 0) return {1, 1};
    return Ratio{std::int64_t{shown.width_px} * mode.height_px, std::int64_t{shown.height_px} * mode.width_px}
        .reduced();
}

Ratio sphere_shape(const ScreenMode& mode, bool corrects_projection, Ratio pixel) {
    return pixel * (corrects_projection ? mode.pixel().inverse() : Ratio{1, 1});
}

std::string describe_shape(Ratio width_to_height) {
    const std::int64_t width = width_to_height.numerator, height = width_to_height.denominator;
    const std::int64_t percent = percent_less(std::min(width, height), std::max(width, height));
    if (percent == 0) return "round";
    return std::to_string(percent) + (width > height ? " % too flat" : " % too narrow");
}

std::string display_name(const ScreenMode& mode) {
    return std::to_string(mode.display.numerator) + ":" + std::to_string(mode.display.denominator);
}

std::string aspect_caption(const ScreenMode& mode, bool corrects_projection, ShownAs shown_as, Scaling scaling,
                           WindowSize window) {
    const Ratio pixel = shown_pixel(layout(window, mode, shown_as, scaling), mode);
    return "Drawn for " + (corrects_projection ? display_name(mode) : "square pixels") + ", shown " +
           name_of(shown_as, mode) + ":\nspheres " + describe_shape(sphere_shape(mode, corrects_projection, pixel)) +
           ", the circle " + describe_shape(pixel * mode.pixel().inverse());
}

std::vector<Pixel> circle_outline(const ScreenMode& mode) {
    const PixelSize pixel = pixel_size(mode);
    const double diameter = kCircle * shorter_side(mode);
    const auto is_inside = [&](std::int32_t x, std::int32_t y) {
        const double across = (2 * x + 1 - mode.width_px) * pixel.width,
                     down = (2 * y + 1 - mode.height_px) * pixel.height;
        return across * across + down * down <= diameter * diameter;
    };
    std::vector<Pixel> outline;
    for (std::int32_t y = 0; y < mode.height_px; ++y)
        for (std::int32_t x = 0; x < mode.width_px; ++x)
            if (is_inside(x, y) &&
                !(is_inside(x - 1, y) && is_inside(x + 1, y) && is_inside(x, y - 1) && is_inside(x, y + 1)))
                outline.push_back({x, y});
    return outline;
}

Area true_square(const ScreenMode& mode) {
    const PixelSize pixel = pixel_size(mode);
    const double side = kSquare * shorter_side(mode);
    const auto columns = static_cast<std::int32_t>(std::lround(side / pixel.width));
    const auto rows = static_cast<std::int32_t>(std::lround(side / pixel.height));
    return {(mode.width_px - columns) / 2, (mode.height_px - rows) / 2, columns, rows};
}

void draw_aspect_guide(const ScreenMode& mode, TextColours colours, Framebuffer canvas) {
    const std::vector<Pixel> circle = circle_outline(mode);
    const Area square = true_square(mode);
    for (const Pixel& at : circle) set_pixel(canvas, at.x + 1, at.y + 1, colours.dark);
    draw_frame_of({square.x + 1, square.y + 1, square.width, square.height}, colours.dark, canvas);
    for (const Pixel& at : circle) set_pixel(canvas, at.x, at.y, colours.bright);
    draw_frame_of(square, colours.bright, canvas);
}

}  // namespace oblong
