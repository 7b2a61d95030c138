#include "game/comparison.h"

#include <algorithm>

#include "tools/common/drawing.h"
#include "tools/common/font.h"

namespace oblong {
namespace {

std::string flip_text(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us) {
    if (options.before == accuracy) return "{flip} Both are " + setting_name(accuracy) + ": turn a dial";
    const bool shows_now = shown_setting(options, accuracy, now_us) == accuracy;
    const auto name = [](const Accuracy& setting, bool is_shown) {
        return is_shown ? "[" + setting_name(setting) + "]" : " " + setting_name(setting) + " ";
    };
    return "{flip} now " + name(accuracy, shows_now) + " before " + name(options.before, !shows_now);
}

}  // namespace

std::int32_t split_column(const LabOptions& options, std::int32_t width_px) {
    return static_cast<std::int32_t>(std::int64_t{options.split_16} * width_px >> 16);
}

void draw_split(const LabOptions& options, Framebuffer right, TextColours colours, Framebuffer canvas) {
    const std::int32_t column = split_column(options, canvas.width_px);
    for (std::int32_t y = 0; y < canvas.height_px; ++y)
        std::copy(right.row(y) + column, right.row(y) + canvas.width_px, canvas.row(y) + column);
    fill_area(canvas, {column - 1, 0, 1, canvas.height_px}, colours.dark);
    fill_area(canvas, {column, 0, 1, canvas.height_px}, colours.bright);
}

std::int32_t draw_split_names(const LabOptions& options, std::string_view left, std::string_view right,
                              std::int32_t bottom, TextColours colours, Framebuffer canvas) {
    const std::int32_t column = split_column(options, canvas.width_px), top = bottom - kLineHeight_px;
    draw_text(part_of(canvas, {0, 0, column, canvas.height_px}), kTextMargin_px, top, left, colours);
    const Framebuffer side = part_of(canvas, {column + 1, 0, canvas.width_px, canvas.height_px});
    draw_text(side, side.width_px - text_width_px(right) - kTextMargin_px, top, right, colours);
    return top;
}

std::int32_t draw_flip_names(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us,
                             std::int32_t bottom, TextColours colours, Framebuffer canvas) {
    return draw_lines_above(bottom, flip_text(options, accuracy, now_us), colours, canvas);
}

}  // namespace oblong
