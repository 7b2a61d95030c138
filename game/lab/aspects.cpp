#include "game/lab/aspects.h"

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

std::string shown_name(ShownAs shown_as, const ScreenMode& mode) {
    if (shown_as == ShownAs::OnDisplay) return "on " + display_name(mode);
    return shown_as == ShownAs::SquarePixels ? "with square pixels" : "in the window's shape";
}

std::string aspect_caption(const ScreenMode& mode, bool corrects_projection, ShownAs shown_as, Scaling scaling,
                           WindowSize window) {
    const Ratio pixel = shown_pixel(layout(window, mode, shown_as, scaling), mode);
    return "Drawn for " + (corrects_projection ? display_name(mode) : "square pixels") + ", shown " +
           shown_name(shown_as, mode) + ":\nspheres " + describe_shape(sphere_shape(mode, corrects_projection, pixel)) +
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
    draw_border(canvas, {square.x + 1, square.y + 1, square.width, square.height}, colours.dark);
    for (const Pixel& at : circle) set_pixel(canvas, at.x, at.y, colours.bright);
    draw_border(canvas, square, colours.bright);
}

namespace {

constexpr std::int32_t kPictureGap_px = 2, kSmallestSide_px = 8;

// The largest part of a cell, in its middle, whose width to height is `shape` in pixels of shape `pixel`.
Area fitted(const Area& cell, Ratio shape, Ratio pixel) {
    const Ratio columns_to_rows = (shape * pixel.inverse()).reduced();
    const std::int64_t columns = cell.height * columns_to_rows.numerator / columns_to_rows.denominator;
    const std::int64_t rows = cell.width * columns_to_rows.denominator / columns_to_rows.numerator;
    const auto width = static_cast<std::int32_t>(std::min<std::int64_t>(cell.width, columns));
    const auto height = static_cast<std::int32_t>(std::min<std::int64_t>(cell.height, rows));
    return {cell.x + (cell.width - width) / 2, cell.y + (cell.height - height) / 2, width, height};
}

Area cell_of(const ScreenMode& mode, int column, int row) {
    const std::int32_t width = mode.width_px / 2, height = mode.height_px / 2;
    return {column * width + kPictureGap_px / 2, row * height + kPictureGap_px / 2, width - kPictureGap_px,
            height - kPictureGap_px};
}

AspectView aspect_view(const ScreenMode& mode, Ratio pixel, bool corrects_projection, bool corrects_display) {
    const Ratio of_pixels{mode.width_px, mode.height_px};
    const Area cell = cell_of(mode, corrects_projection ? 0 : 1, corrects_display ? 0 : 1);
    const Area area = fitted(cell, corrects_display ? mode.display : of_pixels, pixel);
    // The vertical field of view depends only on the projection.
    const ScreenMode small{area.width, area.height, corrects_projection ? mode.display : of_pixels.reduced()};
    return {corrects_projection, corrects_display, cell, area, small};
}

bool can_be_drawn(const ScreenMode& mode, Degrees field_of_view) {
    return std::min(mode.width_px, mode.height_px) >= kSmallestSide_px &&
           is_drawable(make_projection(mode, field_of_view));
}

void copy_picture(Framebuffer from, Framebuffer to) {
    for (std::int32_t row = 0; row < to.height_px; ++row) std::copy_n(from.row(row), to.width_px, to.row(row));
}

void draw_caption(const AspectView& aspect, const ScreenMode& mode, TextColours colours, Framebuffer canvas) {
    const Framebuffer cell = part_of(canvas, aspect.cell);
    const std::string caption = caption_of(aspect, mode);
    const auto height_px = [&] {
        return static_cast<std::int32_t>(lines_across(caption, colours, cell).size()) * kLineHeight_px * colours.scale;
    };
    while (colours.scale > 1 && height_px() > cell.height_px / 3) --colours.scale;
    draw_lines_above(cell.height_px, caption, colours, cell);
}

}  // namespace

std::array<AspectView, 4> four_aspects(const ScreenMode& mode, Ratio pixel) {
    return {aspect_view(mode, pixel, true, true), aspect_view(mode, pixel, false, true),
            aspect_view(mode, pixel, true, false), aspect_view(mode, pixel, false, false)};
}

std::string caption_of(const AspectView& view, const ScreenMode& mode) {
    const auto name = [&](bool is_corrected) { return is_corrected ? display_name(mode) : "square"; };
    const Ratio pixel = view.corrects_display ? mode.pixel() : Ratio{1, 1};
    const std::string drawn = name(view.corrects_projection), shown = name(view.corrects_display);
    return (drawn == shown ? "drawn and shown " + shown : "drawn " + drawn + ", shown " + shown) + ":\n" +
           describe_shape(sphere_shape(mode, view.corrects_projection, pixel));
}

void FourAspects::draw(const GameView& view, const Settings& settings, const ScreenMode& mode, Ratio pixel,
                       TextColours colours, Framebuffer canvas) {
    const std::array<AspectView, 4> aspects = four_aspects(mode, pixel);
    fill_area(canvas, {0, 0, canvas.width_px, canvas.height_px}, colours.dark);
    for (std::size_t i = 0; i < aspects.size(); ++i) {
        draw_view(view, settings, aspects[i], renderers_[i], part_of(canvas, aspects[i].area));
        draw_caption(aspects[i], mode, colours, canvas);
    }
}

void FourAspects::draw_view(const GameView& view, const Settings& settings, const AspectView& aspect,
                            std::unique_ptr<GameRenderer>& renderer, Framebuffer out) {
    if (!can_be_drawn(aspect.mode, view.camera.field_of_view)) return;
    if (!renderer || renderer->mode() != aspect.mode)
        renderer = std::make_unique<GameRenderer>(data_, level_, aspect.mode);
    Settings true_settings = settings;
    true_settings.correct_aspect = true;  // the small mode's display has the shape to correct for
    renderer->draw(view, true_settings);
    copy_picture(renderer->canvas(), out);
}

}  // namespace oblong
