// Sprites: pictures with transparent pixels, drawn from back to front, some of them turned. Catch the moths: the mouse
// moves the net, its button closes it. In the texts: the course notes' painter's algorithm and filled triangles.
#include <oblong.h>

#include <string>

using namespace oblong;

namespace {

constexpr int kNight = 0, kHill = 3, kMoon = 4, kMoths = 6, kReach_px = 16;

// Rows of 13 pixels: digits are colours.
constexpr int kWidth = 13;
constexpr std::string_view kMoth =
    ".....2.2....."
    "11....2....11"
    "1111.222.1111"
    "1121122211211"
    "..111222111.."
    ".11211211211."
    ".1111.2.1111.";
constexpr std::string_view kTree =
    ".....555....."
    "...5555555..."
    ".....555....."
    "...5555555..."
    ".55555555555.";

Picture picture_of(std::string_view digits) {
    Picture picture = Picture::of_size(kWidth, static_cast<int>(digits.size()) / kWidth);
    for (std::size_t i = 0; i < digits.size(); ++i)
        picture.pixels[i] = digits[i] == '.' ? kTransparent : static_cast<std::uint8_t>(digits[i] - '0');
    return picture;
}

void draw_land(Framebuffer canvas, const ScreenMode& mode) {
    clear(canvas, kNight);
    fill_circle(canvas, mode, 250, 44, 24, kMoon);
    fill_triangle(canvas, {-40, 180}, {80, 90}, {200, 180}, kHill);
    fill_triangle(canvas, {120, 180}, {260, 110}, {400, 180}, kHill);
    fill_rectangle(canvas, 0, 180, canvas.width_px, 20, kHill);
    draw_rectangle(canvas, 0, 0, canvas.width_px, canvas.height_px, kMoon);
}

}  // namespace

int main() try {
    Window window("Sprites");
    window.palette.colours = {
        {{16, 20, 48}, {200, 170, 120}, {99, 66, 44}, {24, 48, 44}, {250, 240, 200}, {9, 20, 24}}};
    const Picture moth = picture_of(kMoth), tree = picture_of(kTree);
    std::vector<std::int16_t> falling;  // a tone that falls and fades
    for (int i = 0; i < 4000; ++i)
        falling.push_back(static_cast<std::int16_t>(sine_65536(i * (3000 - i / 2)) * (4000 - i) / 20'000));
    Speaker speaker;
    const int sound = speaker.add(falling, 22'050);
    int caught = 0;
    do {
        const Framebuffer canvas = window.canvas();
        draw_land(canvas, window.mode());
        const PixelPosition net = window.mouse();
        for (int i = 0; i < kMoths; ++i) {
            // Each flies its own loops; each catch changes them.
            const std::int64_t turn = window.time_ms() * (8 + i) + (i + caught) * 15'000;
            const int x = 160 + sine_65536(turn) / 480, y = 90 + sine_65536(turn * 2 + i * 9000) / 900;
            draw_turned(canvas, moth, x, y, sine_65536(turn) / 3, 320 + 64 * i);
            const int aside = net.column - x, down = net.row - y;
            if (!window.was_pressed("Mouse 1") || aside * aside + down * down > kReach_px * kReach_px) continue;
            ++caught;
            speaker.play(sound, 256, aside * 256 / 160);
        }
        for (int x = 6; x < canvas.width_px; x += 28) draw_picture(canvas, tree, x, 172 + x * x % 9);
        draw_circle(canvas, window.mode(), net.column, net.row, window.is_down("Mouse 1") ? 8 : kReach_px, kMoon);
        draw_label(canvas, 6, 6, "caught: " + std::to_string(caught), kMoon);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
