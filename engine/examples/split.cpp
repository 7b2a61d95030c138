// A split screen: each half is a canvas, a part of the window's, and a picture of the same level from another eye. Both
// players see each other as a picture that turns to the eye. W A S D and the arrow keys, or two gamepads; M changes
// from side by side to one above the other.
//
// Usage: example_split [ASSETS]
#include <oblong.h>

#include <algorithm>
#include <array>
#include <string>

using namespace oblong;

namespace {

struct Player {
    Pose eye;
    std::string pad;
    std::array<const char*, 4> keys;  // ahead, back, left, right
    Model figure;
};

Picture make_figure(int coat) {
    Picture figure = Picture::of_size(16, 28);
    clear(figure.canvas(), kTransparent);
    fill_rectangle(figure.canvas(), 3, 8, 10, 14, coat);
    fill_rectangle(figure.canvas(), 4, 22, 3, 6, 2);
    fill_rectangle(figure.canvas(), 9, 22, 3, 6, 2);
    fill_circle(figure.canvas(), {1, 1, {1, 1}}, 8, 5, 4, 14);
    return figure;
}

void walk(Player& player, const LevelScene& level, const Window& window, int passed_ms) {
    const auto pushed_256 = [&](std::size_t key, const char* stick) {
        return std::max(window.pressure_256(player.keys[key]), window.pressure_256(player.pad + stick));
    };
    const int ahead = pushed_256(0, " Left Stick Up") - pushed_256(1, " Left Stick Down"),
              left = pushed_256(2, " Left Stick Left") - pushed_256(3, " Left Stick Right");
    player.eye.yaw_256 += left * passed_ms / 8;
    player.eye = level.walked(player.eye, moved(player.eye, ahead * passed_ms / 5, 0, -passed_ms * 50));
}

}  // namespace

int main(int argc, char** argv) try {
    const std::string assets = argc > 1 ? argv[1] : "build/assets";
    Window window("Split");
    window.palette = load_palette(assets + "/palette.lmp");
    // Half a screen has half of the display's shape, so that its pixels stay what they are.
    ScreenMode half{160, 200, {2, 3}};
    LevelScene level(assets + "/demo.bsp", window.palette, half);
    std::array<Player, 2> players{{{level.start(), "Pad 1", {"W", "S", "A", "D"}, Model::sprite(make_figure(200), 448)},
                                   {moved(level.start(), 200 * 256, 40 * 256),
                                    "Pad 2",
                                    {"Up", "Down", "Left", "Right"},
                                    Model::sprite(make_figure(120), 448)}}};
    players[1].eye.yaw_256 += 170 * 256;
    std::int64_t shown_ms = 0;
    do {
        const int passed_ms = static_cast<int>(std::min<std::int64_t>(window.time_ms() - shown_ms, 100));
        shown_ms = window.time_ms();
        if (window.was_pressed("M"))
            level.set_mode(half = half.width_px == 320 ? ScreenMode{160, 200, {2, 3}} : ScreenMode{320, 100, {8, 3}});
        const bool is_side_by_side = half.width_px == 160;
        const Framebuffer all = window.canvas();
        for (std::size_t i = 0; i < 2; ++i) {
            Player &self = players[i], &other = players[1 - i];
            walk(self, level, window, passed_ms);
            level.show(other.figure, moved(other.eye, 0, 0, -46 * 256));
            std::uint8_t* const first = i == 0 ? all.pixels : is_side_by_side ? all.pixels + 160 : all.row(100);
            level.draw(self.eye, shown_ms, {first, half.width_px, half.height_px, all.pitch},
                       is_side_by_side ? 60 : 90);
        }
        is_side_by_side ? draw_line(all, 160, 0, 160, 199, 0) : draw_line(all, 0, 100, 319, 100, 0);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
