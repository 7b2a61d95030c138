// A textured floor. All pixels of a row below the horizon have the same distance, so that a row needs one division, and
// a pixel two additions. Arrow keys turn and drive. In the texts: the course notes on perspective and textures;
// Muratori's multipliers.
#include <oblong.h>

using namespace oblong;

namespace {

constexpr int kShades = 32, kSky = 3 * kShades;  // colours: three ramps of the floor, one of the sky
constexpr int kHeight = 48;                      // of the eye above the floor, texels

// Positions and distances: 65,536 a texel.
struct Eye {
    std::int64_t x = 0, y = 0;
    int yaw_256 = 20 * 256;
};

// Tiles of 64x64 texels with a border, in two alternating colours.
int texel_at(std::int64_t u, std::int64_t v) {
    const bool is_border = (u & 63) < 4 || (v & 63) < 4;
    return is_border ? 2 : static_cast<int>((u >> 6 ^ v >> 6) & 1);
}

void draw_floor(Framebuffer canvas, const ScreenMode& mode, const Eye& eye) {
    const auto [width, height] = mode.pixel();  // 5 to 6
    const std::int64_t sine = sine_65536(eye.yaw_256), cosine = sine_65536(eye.yaw_256 + 90 * 256),
                       across = mode.width_px / 2;  // half the screen is as far to the side as away: 90 degrees
    for (int y = mode.height_px / 2; y < mode.height_px; ++y) {
        const int below = 2 * (y - mode.height_px / 2) + 1;  // half rows from the horizon to the row's middle
        const std::int64_t ahead = 65536 * 2 * kHeight * across * width / (height * below), step = ahead / across;
        const std::int64_t right = step / 2 - ahead;  // of the row's first pixel
        std::int64_t u = eye.x + ((ahead * cosine + right * sine) >> 16),
                     v = eye.y + ((ahead * sine - right * cosine) >> 16);
        const std::int64_t step_u = step * sine >> 16, step_v = -step * cosine >> 16;
        const int shade = kShades * below / mode.height_px;  // far rows are dark
        for (int x = 0; x < mode.width_px; ++x, u += step_u, v += step_v)
            set_pixel(canvas, x, y, texel_at(u >> 16, v >> 16) * kShades + shade);
    }
}

}  // namespace

int main() try {
    Window window("Floor");
    set_ramp(window.palette, 0, kShades - 1, {10, 10, 30}, {180, 90, 50});
    set_ramp(window.palette, kShades, 2 * kShades - 1, {10, 10, 30}, {230, 200, 150});
    set_ramp(window.palette, 2 * kShades, 3 * kShades - 1, {10, 10, 30}, {60, 60, 80});
    set_ramp(window.palette, kSky, kSky + kShades - 1, {40, 60, 140}, {10, 10, 30});
    Eye eye;
    std::int64_t shown_ms = 0;
    do {
        const std::int64_t passed_ms = window.time_ms() - shown_ms;
        shown_ms += passed_ms;
        eye.yaw_256 += static_cast<int>(passed_ms * 20 * (window.is_down("Left") - window.is_down("Right")));
        const std::int64_t texels_s = window.is_down("Up") ? 240 : window.is_down("Down") ? 0 : 80;
        eye.x += sine_65536(eye.yaw_256 + 90 * 256) * texels_s * passed_ms / 1000;
        eye.y += sine_65536(eye.yaw_256) * texels_s * passed_ms / 1000;

        const int horizon = window.mode().height_px / 2;
        for (int y = 0; y < horizon; ++y)
            fill_rectangle(window.canvas(), 0, y, window.mode().width_px, 1, kSky + y * kShades / horizon);
        draw_floor(window.canvas(), window.mode(), eye);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
