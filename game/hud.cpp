#include "game/hud.h"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/common/font.h"

namespace oblong {
namespace {

constexpr std::uint64_t kMessageStays_us = 2'500'000;
constexpr std::int32_t kMargin_px = 4, kPanelSide_px = 10;

constexpr std::array<std::string_view, 17> kHelp{
    "Oblong",
    "",
    "W A S D, arrows   walk, turn",
    "Mouse             look (a click captures it)",
    "Page Up, Down     look up, down",
    "Space             jump, swim up",
    "Shift             walk slowly",
    "",
    "F1                this help",
    "F2                aspect in the projection",
    "F3                aspect on the display",
    "F4                accuracy",
    "F5                scaling",
    "F6                cost of a frame",
    "F12               screenshots",
    "Alt+Enter         whole screen",
    "Esc               free the mouse, then leave",
};

void draw_end(std::string_view message, TextColours colours, Framebuffer canvas) {
    std::vector<std::string_view> lines =
        lines_of(message.empty() ? "You have reached the end." : message, canvas.width_px - 2 * kPanelSide_px);
    lines.insert(lines.end(), {"", "Thank you for playing.", "Esc frees the mouse, then leaves."});
    draw_panel(canvas, lines, colours);
}

void draw_message(std::string_view message, TextColours colours, Framebuffer canvas) {
    std::int32_t y = kMargin_px;
    for (const std::string_view line : lines_of(message, canvas.width_px - 2 * kMargin_px)) {
        draw_text(canvas, kMargin_px, y, line, colours);
        y += kLineHeight_px;
    }
}

}  // namespace

void show_message(Hud& hud, std::string message, std::uint64_t now_us) {
    hud.message = std::move(message);
    hud.message_ends_us = now_us + kMessageStays_us;
}

void draw_hud(const Hud& hud, std::uint64_t now_us, TextColours colours, Framebuffer canvas) {
    if (hud.shows_end) draw_end(hud.end_message, colours, canvas);
    if (hud.shows_help) draw_panel(canvas, kHelp, colours);
    if (!hud.message.empty() && now_us < hud.message_ends_us) draw_message(hud.message, colours, canvas);
    if (!hud.cost.empty())
        draw_text(canvas, kMargin_px, canvas.height_px - kLineHeight_px - kMargin_px, hud.cost, colours);
}

}  // namespace oblong
