#include "game/hud.h"

#include <algorithm>
#include <string_view>

#include "tools/common/font.h"

namespace oblong {
namespace {

constexpr std::int32_t kPanelMargin_px = 6, kTextGap_px = 2;

std::int32_t line_px(TextColours colours) {
    return kLineHeight_px * colours.scale;
}

std::int32_t height_of(const std::string& text, TextColours colours, Framebuffer canvas) {
    return static_cast<std::int32_t>(lines_across(text, colours, canvas).size()) * line_px(colours);
}

// Takes so many rows from the bottom of a room; none if they are not there.
RowRange take_below(std::int32_t height, RowRange& room) {
    if (height <= 0 || height > room.height()) return {};
    room.bottom -= height;
    return {room.bottom, room.bottom + height};
}

RowRange panel_rows(const std::vector<std::string>& lines, std::int32_t scale, Framebuffer canvas) {
    const std::int32_t height =
        (static_cast<std::int32_t>(lines.size()) * kLineHeight_px + 2 * kPanelMargin_px) * scale;
    const std::int32_t top = std::max((canvas.height_px - height) / 2, 0);
    return {top, std::min(top + height, canvas.height_px)};
}

std::int32_t panel_scale(const std::vector<std::string>& lines, TextColours colours, Framebuffer canvas) {
    std::int32_t width = 0;
    for (const std::string& line : lines) width = std::max(width, text_width_px(line));
    const std::int32_t height = static_cast<std::int32_t>(lines.size()) * kLineHeight_px;
    const std::int32_t most = std::min(canvas.width_px / std::max(width, 1), canvas.height_px / std::max(height, 1));
    return std::clamp(most, 1, colours.scale);
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
    RowRange above{kTextGap_px, std::max(bottom, kTextGap_px)};
    RowRange below = above;
    const bool has_help = !text.help.empty();
    if (has_help) {
        layout.help_scale = panel_scale(text.help, colours, canvas);
        layout.help = panel_rows(text.help, layout.help_scale, canvas);
        above.bottom = std::min(above.bottom, layout.help.top);
        below.top = std::max(below.top, layout.help.bottom);
    } else if (has_messages) {
        below.top += std::min(line_px(colours), below.height());
    }
    const std::string captions = joined(text.captions);
    if (!captions.empty()) layout.captions = take_below(height_of(captions, colours, canvas), below);
    for (const std::string& note : text.notes)
        layout.notes.push_back(take_below(height_of(note, colours, canvas), below));
    if (text.cost != nullptr) layout.cost = take_below(cost_height_px(*text.cost, canvas), below);
    layout.messages = above;
    if (!has_help) layout.messages.bottom = std::max(below.bottom, above.top);
    return layout;
}

void draw_hud(const HudText& text, Messages& messages, std::uint64_t now_us, std::int32_t bottom, TextColours colours,
              const ColourTable& background, Framebuffer canvas) {
    const HudLayout layout = lay_out_hud(text, !messages.is_empty(), bottom, colours, canvas);
    const TextColours small{colours.bright, colours.dark, 1};
    if (layout.cost.height() > 0) draw_cost(*text.cost, layout.cost.bottom, small, canvas);
    for (std::size_t i = 0; i < text.notes.size(); ++i)
        draw_on_background(layout.notes[i], lines_across(text.notes[i], colours, canvas), colours, background, canvas);
    const std::string captions = joined(text.captions);
    draw_on_background(layout.captions, lines_across(captions, colours, canvas), colours, background, canvas);
    if (!text.help.empty()) {
        const std::vector<std::string_view> lines(text.help.begin(), text.help.end());
        draw_panel(canvas, lines, {colours.bright, colours.dark, layout.help_scale});
    }
    const std::int32_t columns = (canvas.width_px - 2 * kTextMargin_px) / (kGlyphAdvance_px * colours.scale);
    const auto most_lines = static_cast<std::size_t>(layout.messages.height() / line_px(colours));
    draw_on_background(layout.messages, messages.lines(now_us, std::max(columns, 1), most_lines), colours, background,
                       canvas);
}

}  // namespace oblong
