#include <algorithm>
#include <exception>
#include <memory>
#include <vector>

#include "engine/platform/sdl/sdl.h"
#include "engine/surface/palette.h"
#include "game/input/input_mapper.h"
#include "game/menu/menu.h"
#include "game/program/program.h"

namespace oblong {

void show_error(const std::string& text, Platform& platform) {
    constexpr std::int32_t kAnyTime_ms = 1000;
    const ScreenMode mode;
    std::vector<std::uint8_t> pixels(pixel_count(mode.width_px, mode.height_px));
    const Framebuffer canvas{pixels.data(), mode.width_px, mode.height_px, mode.width_px};
    const Palette palette = even_colours();
    const MenuLook look(palette);
    const Bindings bindings = default_bindings();
    InputMapper input(bindings);
    Menu menu;
    menu.open([&text] {
        MenuPage page{"Oblong can't go on", text};
        page.help = "Enter or Esc closes this window.";
        return page;
    });
    while (platform.is_open()) {
        const PresentRect rect = layout(platform.window_size(), mode, ShownAs::OnDisplay, Scaling::SharpBilinear);
        menu.handle(input.take(platform.poll(), platform.now_us() / 1000), {mode.width_px, mode.height_px}, 1, rect);
        if (!menu.is_open()) return;
        std::fill(pixels.begin(), pixels.end(), std::uint8_t{0});
        menu.draw(1, look, palette, canvas);
        platform.present(canvas, palette, rect);
        platform.wait_for_input(kAnyTime_ms);
    }
}

void show_error_window(const std::string& text) {
    std::unique_ptr<Platform> platform;
    try {
        platform = open_window("Oblong - error", {});
    } catch (const std::exception&) {
        return;
    }
    show_error(text, *platform);
}

}  // namespace oblong
