// Plasma by cycling the palette. A sum of four waves is drawn once; after that only the 256 colours move: 768 bytes for
// a picture instead of 64,000.
#include <oblong.h>

using namespace oblong;

namespace {

// The sum of the four waves at a place, from -4 * 65,536 to 4 * 65,536. The last term makes rings: its angle grows with
// the square of the distance.
int height(int x, int y) {
    constexpr int kDegree = 256;
    const int right = x - 160, down = y - 120;
    return sine_65536(3 * kDegree * x) + sine_65536(4 * kDegree * y) + sine_65536(2 * kDegree * (x + y)) +
           sine_65536(3 * (right * right + down * down));
}

}  // namespace

int main() try {
    Window window("Plasma");
    // The last ramp ends where the first begins, so that the colours can go round.
    set_ramp(window.palette, 0, 63, {16, 0, 48}, {180, 20, 90});
    set_ramp(window.palette, 64, 127, {180, 20, 90}, {255, 200, 60});
    set_ramp(window.palette, 128, 191, {255, 200, 60}, {20, 120, 140});
    set_ramp(window.palette, 192, 255, {20, 120, 140}, {16, 0, 48});
    const Palette at_first = window.palette;

    const Framebuffer canvas = window.canvas();
    for (int y = 0; y < canvas.height_px; ++y)
        for (int x = 0; x < canvas.width_px; ++x)
            set_pixel(canvas, x, y, height(x, y * 6 / 5) / 1536);  // a row is 6/5 as high as a column is wide

    do {
        window.palette = at_first;
        cycle_colours(window.palette, 0, 255, window.time_ms() / 20);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
