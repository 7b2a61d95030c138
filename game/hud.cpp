#include "game/hud.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace oblong {
namespace {

constexpr std::uint64_t kMessageStays_us = 2'500'000, kLetterStays_us = 50'000;

// At most 51 columns: with its margins a panel of 318 pixels.
constexpr std::array<std::string_view, 15> kHelp{
    "W A S D, arrows  walk, turn    Space  jump, swim up",
    "Mouse (click), Page Up, Down  look    Shift  slowly",
    "",
    "Aspect                     Accuracy",
    "F2   of the projection     F4   next preset",
    "F3   of the display        F6   cost of a frame",
    "F11  circle and square     F7   lab: dials, costs",
    "4    F2 and F3, all four   F8   map of the error",
    "Picture                    F9   split with exact",
    "F5   scaling               F10  flip two settings",
    "I    isometric             [ ]  zoom against dolly",
    "Tab  map   E  edges        P    what is ahead",
    "- =  brightness   L torch  C    look of a tube",
    "F12  screenshots   O log   F1   this help",
    "Alt+Enter whole screen    Esc free the mouse, leave",
};

}  // namespace

void show_message(Hud& hud, std::string message, std::uint64_t now_us) {
    hud.message = std::move(message);
    hud.message_ends_us = now_us + std::max(kMessageStays_us, hud.message.size() * kLetterStays_us);
}

void draw_hud(const Hud& hud, std::uint64_t now_us, std::int32_t bottom, TextColours colours, Framebuffer canvas) {
    draw_cost(hud.cost, bottom, colours, canvas);
    if (hud.shows_help) draw_panel(canvas, kHelp, colours);
    if (!hud.message.empty() && now_us < hud.message_ends_us) draw_lines(kTextMargin_px, hud.message, colours, canvas);
}

}  // namespace oblong
