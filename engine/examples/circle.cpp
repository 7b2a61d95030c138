// The same circle in four modes. Left is draw_circle(), which uses the shape of the mode's pixels and is round in each;
// right is a circle with as many rows as columns, which is an ellipse unless pixels are square. In the texts:
// Muratori's "Dealing with Aspect Ratios".
#include <oblong.h>

#include <algorithm>
#include <array>
#include <string>

using namespace oblong;

namespace {

constexpr int kDark = 0, kBlue = 1, kWhite = 2, kRed = 3, kEach_ms = 2000;
// All shown on a display of 4:3.
constexpr std::array<ScreenMode, 4> kModes{{{320, 200}, {320, 240}, {640, 200}, {640, 480}}};

void draw_egg(Framebuffer canvas, int x, int y, int radius_px, int colour) {
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const auto along = [&](int angle) { return radius_px * sine_65536(angle * 256) / 65536; };
        draw_line(canvas, x + along(degrees + 90), y + along(degrees), x + along(degrees + 95), y + along(degrees + 5),
                  colour);
    }
}

std::string text_of(const ScreenMode& mode) {
    const Ratio pixel = mode.pixel();
    return std::to_string(mode.width_px) + "x" + std::to_string(mode.height_px) + ": a pixel is " +
           std::to_string(pixel.numerator) + ":" + std::to_string(pixel.denominator);
}

}  // namespace

int main() try {
    Window window("The same circle");
    window.palette.colours = {{{16, 16, 24}, {40, 70, 120}, {240, 240, 230}, {220, 80, 60}}};
    do {
        const ScreenMode mode = kModes[static_cast<std::size_t>(window.time_ms() / kEach_ms) % kModes.size()];
        if (!(window.mode() == mode)) window.set_mode(mode);
        const Framebuffer canvas = window.canvas();
        const int left = mode.width_px / 4, right = mode.width_px * 3 / 4, middle = mode.height_px / 2;
        const int radius_px = std::min(left, middle) * 4 / 5;
        clear(canvas, kDark);
        fill_circle(canvas, mode, left, middle, radius_px, kBlue);
        draw_circle(canvas, mode, left, middle, radius_px, kWhite);
        draw_egg(canvas, right, middle, radius_px, kRed);
        draw_label(canvas, 4, 4, text_of(mode), kWhite, mode.height_px / 200);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
