#include "game/view/hud.h"

#include <algorithm>
#include <string_view>

#include "engine/base/table.h"
#include "engine/draw/text.h"

namespace oblong {
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
