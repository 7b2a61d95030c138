#include "game/lab/comparison.h"

#include <algorithm>

#include "engine/draw/drawing.h"
#include "engine/draw/font.h"

namespace oblong {
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

std::string split_text(std::string_view left) {
    return "{split} left: " + std::string(left) + ", right: exact";
}

std::string flip_text(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us) {
    if (options.before == accuracy) return "{flip} Both are " + setting_name(accuracy) + ": turn a dial";
    const bool shows_now = shown_setting(options, accuracy, now_us) == accuracy;
    const auto name = [](const Accuracy& setting, bool is_shown) {
        return is_shown ? "[" + setting_name(setting) + "]" : " " + setting_name(setting) + " ";
    };
    return "{flip} now " + name(accuracy, shows_now) + " before " + name(options.before, !shows_now);
}

}  // namespace oblong
