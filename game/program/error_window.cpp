#include <exception>
#include <memory>
#include <vector>

#include "engine/draw/drawing.h"
#include "engine/platform/sdl/sdl.h"
#include "game/input/input_mapper.h"
#include "game/program/program.h"

namespace oblong {
namespace {

constexpr std::uint8_t kWindowBackground = 1, kBright = 2, kGrey = 3;
constexpr std::int32_t kTextTop_px = 40, kTitleTop_px = 16;

Palette error_palette() {
    Palette palette;
    palette.colours[kWindowBackground] = {40, 16, 24};
    palette.colours[kBright] = {255, 240, 168};
    palette.colours[kGrey] = {160, 144, 144};
    return palette;
}

void draw_error(const std::string& text, Framebuffer canvas) {
    draw_lines(kTitleTop_px, "Oblong can't go on", {kBright, 0}, canvas);
    draw_lines(kTextTop_px, text, {kBright, 0}, canvas);
    draw_lines_above(canvas.height_px - kTextMargin_px, "Enter or Esc closes this window.", {kGrey, 0}, canvas);
}

bool is_dismissed(const Controls& controls) {
    return !controls.menu.empty() || controls.has(Action::Menu) || (controls.pointer && controls.pointer->is_pressed);
}

void show_until_dismissed(const std::string& text, Platform& platform) {
    constexpr std::int32_t kAnyTime_ms = 1000;
    const ScreenMode mode;
    std::vector<std::uint8_t> pixels(pixel_count(mode.width_px, mode.height_px), kWindowBackground);
    const Framebuffer canvas{pixels.data(), mode.width_px, mode.height_px, mode.width_px};
    draw_error(text, canvas);
    const Bindings bindings = default_bindings();
    InputMapper input(bindings);
    while (platform.is_open() && !is_dismissed(input.take(platform.poll(), platform.now_us() / 1000))) {
        platform.present(canvas, error_palette(),
                         layout(platform.window_size(), mode, ShownAs::OnDisplay, Scaling::SharpBilinear));
        platform.wait_for_input(kAnyTime_ms);
    }
}

}  // namespace

void show_error_window(const std::string& text) {
    std::unique_ptr<Platform> platform;
    try {
        platform = open_window("Oblong - error", {});
    } catch (const std::exception&) {
        return;
    }
    show_until_dismissed(text, *platform);
}

}  // namespace oblong
