// Fire: each pixel becomes the mean of the pixels below it, minus a small random amount; the lowest row is fuel. It
// burns 70 times a second, at any frame rate. Space removes the fuel.
#include <oblong.h>

#include <algorithm>

using namespace oblong;

namespace {

constexpr int kRate_hz = 70, kHottest = 255, kLog_px = 8;

// Logs of eight columns, of random heat; a few change each time.
void lay_fuel(Framebuffer fire, bool is_out, std::uint64_t& random) {
    for (int x = 0; x < fire.width_px; x += kLog_px)
        if (is_out || random_below(8, random) == 0)
            fill_rectangle(fire, x, fire.height_px - 1, kLog_px, 1,
                           is_out ? 0 : kHottest - 50 * random_below(4, random));
}

void burn(Framebuffer fire, std::uint64_t& random) {
    for (int y = 0; y < fire.height_px - 1; ++y)
        for (int x = 0; x < fire.width_px; ++x) {
            const int around = pixel_at(fire, x - 1, y + 1) + pixel_at(fire, x, y + 1) + pixel_at(fire, x + 1, y + 1) +
                               pixel_at(fire, x, std::min(y + 2, fire.height_px - 1));
            set_pixel(fire, x, y, std::max(around / 4 - random_below(3, random), 0));
        }
}

}  // namespace

int main() try {
    Window window("Fire");
    // A colour's index is its heat.
    set_ramp(window.palette, 0, 63, {0, 0, 0}, {120, 0, 0});
    set_ramp(window.palette, 64, 127, {120, 0, 0}, {250, 100, 0});
    set_ramp(window.palette, 128, 191, {250, 100, 0}, {255, 230, 80});
    set_ramp(window.palette, 192, 255, {255, 230, 80}, {255, 255, 255});

    std::uint64_t random = 1;
    std::int64_t steps = 0;
    do {
        for (; steps < window.time_ms() * kRate_hz / 1000; ++steps) {
            lay_fuel(window.canvas(), window.is_down("Space"), random);
            burn(window.canvas(), random);
        }
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
