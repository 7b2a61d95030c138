// All that a player does: keys by their places, text with repeats as typed, the mouse with its wheel, two gamepads.
// What is held is bright, what was just let go flashes. Escape ends.
#include <oblong.h>

#include <array>
#include <string>

using namespace oblong;

namespace {

constexpr int kDark = 43, kHeld = 180, kLetGo = 174, kInk = 255;  // of the window's own palette
constexpr int kLine_px = 10, kMargin_px = 8;

void draw_key(const Window& window, Framebuffer canvas, int x, int y, const std::string& input,
              const std::string& says) {
    const int width = text_width_px(says) + 4;
    const bool is_held = window.is_down(input);
    fill_rectangle(canvas, x, y, width, 12, window.was_released(input) ? kLetGo : is_held ? kHeld : kDark);
    draw_label(canvas, x + 2, y + 2, says, is_held ? 0 : kInk);
}

void draw_keyboard(const Window& window, Framebuffer canvas) {
    constexpr std::array<std::string_view, 4> kRows{"1234567890", "QWERTYUIOP", "ASDFGHJKL", "ZXCVBNM"};
    for (int row = 0; row < 4; ++row)
        for (int i = 0; const char letter : kRows[static_cast<std::size_t>(row)])
            draw_key(window, canvas, kMargin_px + row * 5 + i++ * 13, 10 + row * 15, {letter}, {letter});
    for (int x = kMargin_px;
         const std::string key : {"Left Shift", "Left Ctrl", "Space", "Left", "Up", "Down", "Right"}) {
        draw_key(window, canvas, x, 72, key, key);
        x += text_width_px(key) + 8;
    }
}

void draw_pad(const Window& window, Framebuffer canvas, int x, const std::string& pad) {
    draw_label(canvas, x, 96, pad, kInk);
    for (int at = x; const std::string stick : {"Left Stick ", "Right Stick "}) {
        const std::string name = pad + " " + stick;
        const auto pushed = [&](const char* to, const char* from) {
            return (window.pressure_256(name + to) - window.pressure_256(name + from)) / 20;
        };
        draw_circle(canvas, window.mode(), at + 14, 120, 14, kInk);
        fill_circle(canvas, window.mode(), at + 14 + pushed("Right", "Left"), 120 + pushed("Down", "Up"), 4, kHeld);
        at += 34;
    }
    for (int at = x + 70; const std::string button : {"A", "B", "X", "Y"}) {
        draw_key(window, canvas, at, 114, pad + " " + button, button);
        at += 13;
    }
}

}  // namespace

int main() try {
    Window window("Input");
    std::string text = "Type here, with accents too; Backspace takes a letter away.";
    int notches = 0;
    do {
        const Framebuffer canvas = window.canvas();
        clear(canvas);
        draw_keyboard(window, canvas);
        draw_pad(window, canvas, kMargin_px, "Pad 1");
        draw_pad(window, canvas, 168, "Pad 2");
        add_typed(text, window.typed());
        for (int y = 146; const std::string& line : wrapped(text + "_", canvas.width_px - 2 * kMargin_px))
            draw_label(canvas, kMargin_px, (y += kLine_px) - kLine_px, line, kInk);
        notches += window.press_count("Wheel Up") - window.press_count("Wheel Down");
        draw_label(canvas, 190, 12, "wheel " + std::to_string(notches), kInk);
        for (int i = 1; i <= 3; ++i)
            draw_key(window, canvas, 190, 12 + 15 * i, "Mouse " + std::to_string(i), "mouse " + std::to_string(i));
        draw_circle(canvas, window.mode(), window.mouse().column, window.mouse().row, 3, kInk);
        if (window.was_pressed("Escape")) window.close();
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
