#include "game/view/hud.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "engine/base/table.h"
#include "engine/draw/text.h"

namespace oblong {
namespace {

constexpr std::uint64_t kLeast_us = 2'500'000, kLetter_us = 60'000;
constexpr std::size_t kMostTold = 32;

std::vector<std::string_view> wrapped(const std::string& text, std::int32_t columns) {
    return lines_of(text, columns * kGlyphAdvance_px);
}

}  // namespace

std::uint64_t Messages::reading_time_us(const std::string& text) {
    return std::max(kLeast_us, text.size() * kLetter_us);
}

void Messages::show(std::string text) {
    std::erase(told_, text);
    told_.insert(told_.begin(), text);
    if (told_.size() > kMostTold) told_.pop_back();
    const std::uint64_t time_us = reading_time_us(text);
    parts_.assign(1, {std::move(text), time_us});
    is_up_ = false;
}

void Messages::pass_time(std::uint64_t now_us) {
    const std::uint64_t elapsed_us = now_us - std::exchange(last_us_, now_us);
    if (!std::exchange(is_up_, false)) return;
    Part& up = parts_.front();
    up.left_us -= std::min(up.left_us, elapsed_us);
    if (up.left_us == 0) parts_.erase(parts_.begin());
}

// The rest becomes the next part.
void Messages::split_first(std::int32_t columns, std::size_t most_lines) {
    Part& first = parts_.front();
    const std::vector<std::string_view> all = wrapped(first.text, columns);
    if (all.size() <= most_lines) return;
    const auto kept = as_size(all[most_lines].data() - first.text.data());
    std::string rest = first.text.substr(kept);
    const std::uint64_t time_us = reading_time_us(rest);
    first.text.resize(kept);
    while (!first.text.empty() && (first.text.back() == ' ' || first.text.back() == '\n')) first.text.pop_back();
    first.left_us = std::min(first.left_us, reading_time_us(first.text));
    parts_.insert(parts_.begin() + 1, {std::move(rest), time_us});
}

std::vector<std::string> Messages::lines(std::uint64_t now_us, std::int32_t columns, std::size_t most_lines) {
    pass_time(now_us);
    if (parts_.empty() || most_lines == 0) return {};
    split_first(columns, most_lines);
    is_up_ = true;
    const std::vector<std::string_view> shown = wrapped(parts_.front().text, columns);
    return {shown.begin(), shown.end()};
}

namespace {

constexpr std::int32_t kTextGap_px = 2;
constexpr std::size_t kMostMessageLines = 3;  // so that the picture stays visible

std::int32_t line_px(TextColours colours) {
    return kLineHeight_px * colours.scale;
}

std::int32_t height_of(const std::string& text, TextColours colours, Framebuffer canvas) {
    return static_cast<std::int32_t>(lines_across(text, colours, canvas).size()) * line_px(colours);
}

// Takes `height` rows from the bottom of a room; none if it has fewer.
RowRange take_below(std::int32_t height, RowRange& room) {
    if (height <= 0 || height > room.height()) return {};
    room.bottom -= height;
    return {room.bottom, room.bottom + height};
}

void draw_on_background(std::int32_t y, std::string_view line, TextColours colours, const ColourTable& background,
                        Framebuffer canvas) {
    const std::int32_t width = text_width_px(line) * colours.scale + kTextMargin_px;
    recolour_area(canvas, {kTextMargin_px / 2, y - colours.scale, width, line_px(colours)}, background);
    draw_text(canvas, kTextMargin_px, y, line, colours);
}

template <class Lines>
void draw_on_background(RowRange rows, const Lines& lines, TextColours colours, const ColourTable& background,
                        Framebuffer canvas) {
    std::int32_t y = rows.top + colours.scale;
    for (const auto& line : lines) {
        if (y + line_px(colours) - colours.scale > rows.bottom) return;
        draw_on_background(y, line, colours, background, canvas);
        y += line_px(colours);
    }
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
}

}  // namespace

HudLayout lay_out_hud(const HudText& text, bool has_messages, std::int32_t bottom, TextColours colours,
                      Framebuffer canvas) {
    HudLayout layout;
    const std::int32_t top = kTextGap_px;
    RowRange below{top, std::max(bottom, top)};
    if (has_messages) below.top += std::min(line_px(colours), below.height());
    const std::string captions = joined(text.captions);
    if (!captions.empty()) layout.captions = take_below(height_of(captions, colours, canvas), below);
    for (const std::string& note : text.notes)
        layout.notes.push_back(take_below(height_of(note, colours, canvas), below));
    if (text.cost != nullptr) {
        const std::int32_t panels_top = canvas.height_px - panel_room_px(canvas, colours.scale);
        const std::int32_t room_px = below.bottom - std::max(below.top, panels_top);
        layout.cost_table = lay_out_cost(*text.cost, room_px, colours, canvas);
        if (text.cost_page <= layout.cost_table.pages) layout.cost = take_below(layout.cost_table.height_px, below);
    }
    layout.messages = {top, std::max(below.bottom, top)};
    return layout;
}

HudLayout draw_hud(const HudText& text, Messages& messages, std::uint64_t now_us, std::int32_t bottom,
                   TextColours colours, const ColourTable& background, Framebuffer canvas) {
    const HudLayout layout = lay_out_hud(text, !messages.is_empty(), bottom, colours, canvas);
    if (layout.cost.height() > 0)
        draw_cost(*text.cost, layout.cost_table, text.cost_page, layout.cost.bottom, colours, canvas);
    for (std::size_t i = 0; i < text.notes.size(); ++i)
        draw_on_background(layout.notes[i], lines_across(text.notes[i], colours, canvas), colours, background, canvas);
    const std::string captions = joined(text.captions);
    draw_on_background(layout.captions, lines_across(captions, colours, canvas), colours, background, canvas);
    const std::int32_t columns = (canvas.width_px - 2 * kTextMargin_px) / (kGlyphAdvance_px * colours.scale);
    const auto most_lines = std::min(kMostMessageLines, as_size(layout.messages.height() / line_px(colours)));
    draw_on_background(layout.messages, messages.lines(now_us, std::max(columns, 1), most_lines), colours, background,
                       canvas);
    return layout;
}

}  // namespace oblong
