#include "game/lab/four_aspects.h"

#include <algorithm>

#include "engine/draw/text.h"

namespace oblong {
namespace {

constexpr std::int32_t kGap_px = 2, kSmallestSide_px = 8;

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
    return {column * width + kGap_px / 2, row * height + kGap_px / 2, width - kGap_px, height - kGap_px};
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

bool is_same(const ScreenMode& a, const ScreenMode& b) {
    return a.width_px == b.width_px && a.height_px == b.height_px && a.display == b.display;
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
    if (!renderer || !is_same(renderer->mode(), aspect.mode))
        renderer = std::make_unique<GameRenderer>(data_, level_, aspect.mode);
    Settings true_settings = settings;
    true_settings.correct_aspect = true;  // the small mode's display has the shape to correct for
    renderer->draw(view, true_settings);
    copy_picture(renderer->canvas(), out);
}

}  // namespace oblong
