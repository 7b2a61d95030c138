// A sheet of frames: parts of a picture, shown in turn. Walkers to the left are mirrored; in the water all are upside
// down, and the palette's second half has its colours mixed with the water's. The sheet is drawn here, once.
#include <oblong.h>

using namespace oblong;

namespace {

constexpr int kFrames = 8, kWidth = 24, kHeight = 32, kGround = 130;
constexpr int kSky = 1, kEarth = 2, kSkin = 3, kCoat = 4, kHat = 5, kBoots = 6, kWater = 7, kMirrored = 128;

// One leg and one arm swing ahead while the others swing back.
void draw_frame(Framebuffer frame, int number) {
    const int swing = sine_65536(number * 360 * 256 / kFrames) * 6 / 65536, bob = swing * swing / 18;
    const auto limb = [&](int top, int length, int ahead, int colour) {
        for (int wide = -1; wide <= 1; ++wide)
            draw_line(frame, 11 + wide, top + bob, 11 + wide + ahead, top + length, colour);
    };
    limb(20, 10, -swing, kBoots);
    limb(14, 9, swing, kCoat);
    fill_rectangle(frame, 8, 11 + bob, 8, 11, kCoat);
    limb(20, 10, swing, kBoots);
    limb(14, 9, -swing, kSkin);
    fill_circle(frame, {}, 12, 8 + bob, 4, kSkin);
    fill_rectangle(frame, 7, 3 + bob, 9, 3, kHat);
    fill_rectangle(frame, 14, 5 + bob, 5, 1, kHat);
}

Picture make_sheet() {
    Picture sheet = Picture::of_size(kFrames * kWidth, kHeight);
    clear(sheet.canvas(), kTransparent);
    const Framebuffer all = sheet.canvas();
    for (int i = 0; i < kFrames; ++i) draw_frame({all.pixels + i * kWidth, kWidth, kHeight, all.pitch}, i);
    return sheet;
}

}  // namespace

int main() try {
    Window window("Sheet");
    window.palette.colours = {{{0, 0, 0},
                               {150, 190, 220},
                               {90, 110, 70},
                               {230, 180, 150},
                               {160, 50, 50},
                               {60, 40, 30},
                               {40, 40, 60},
                               {50, 90, 130}}};
    const Palette wet = mixed(window.palette, {50, 90, 130}, 150);
    for (std::size_t i = 0; i < kMirrored; ++i) window.palette.colours[i + kMirrored] = wet.colours[i];
    window.palette.colours[kTransparent] = {200, 200, 190};
    const Picture sheet = make_sheet();
    Picture mirrored = sheet, icon = Picture::of_size(kHeight, kHeight);
    for (std::uint8_t& pixel : mirrored.pixels)
        if (pixel != kTransparent) pixel |= kMirrored;
    draw_part(icon.canvas(), sheet, {.width_px = kWidth, .height_px = kHeight, .is_opaque = true}, 4, 0);
    window.set_icon(icon);
    do {
        const Framebuffer canvas = window.canvas();
        clear(canvas, kSky);
        fill_rectangle(canvas, 0, kGround - 14, canvas.width_px, 14, kEarth);
        fill_rectangle(canvas, 0, kGround, canvas.width_px, canvas.height_px, kWater);
        draw_part(canvas, sheet, {.width_px = sheet.width_px, .height_px = kHeight, .is_opaque = true}, 64, 12);
        for (int i = 0; i < 9; ++i) {
            const int speed_px = 24 + 5 * i, row = kGround - 6 - kHeight + i / 2;
            const int way = static_cast<int>(window.time_ms() * speed_px / 1000 + i * 100) % (canvas.width_px + kWidth);
            const bool is_left = i % 2 == 1;
            const int x = (is_left ? canvas.width_px - way : way - kWidth);
            PicturePart part{way / 4 % kFrames * kWidth, 0, kWidth, kHeight, is_left};
            draw_part(canvas, sheet, part, x, row);
            part.is_upside_down = true;
            draw_part(canvas, mirrored, part, x, 2 * kGround - row - kHeight);
        }
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
