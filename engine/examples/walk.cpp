// A level to walk: W A S D and the mouse, or a gamepad; Space jumps, E opens doors on hinges, F fills the screen, M
// ends the music, Escape the program. The level handles collisions; the speed is the program's. In the texts:
// LevelScene::draw() does all stages of Princeton's "Polygon Pipeline"; Abrash's BSP tree; the course notes' camera of
// first-person games.
//
// Usage: example_walk [ASSETS [LEVEL]]
#include <oblong.h>

#include <algorithm>
#include <cstdio>

using namespace oblong;

namespace {

constexpr int kSpeed = 280, kJump = 270, kGravity = 800;  // units a second; gravity: units a second squared

// From -256 to 256: two opposite keys, and two directions of the pad's stick.
int pressure_256(const Window& window, std::string_view minus, std::string_view plus, const std::string& stick_minus,
                 const std::string& stick_plus) {
    return std::clamp(window.pressure_256(plus) - window.pressure_256(minus) +
                          window.pressure_256("Pad " + stick_plus) - window.pressure_256("Pad " + stick_minus),
                      -256, 256);
}

Pose turned(Pose eye, const Window& window, int passed_ms) {
    const int right = pressure_256(window, "Left", "Right", "Right Stick Left", "Right Stick Right") * passed_ms / 8,
              down = pressure_256(window, "Up", "Down", "Right Stick Up", "Right Stick Down") * passed_ms / 16;
    eye.yaw_256 -= window.mouse_motion().column * 40 + right;
    eye.pitch_256 = std::clamp(eye.pitch_256 + window.mouse_motion().row * 40 + down, -80 * 256, 80 * 256);
    return eye;
}

}  // namespace

int main(int argc, char** argv) try {
    const std::string assets = argc > 1 ? argv[1] : "build/assets";
    Window window("Walk");
    const Palette palette = load_palette(assets + "/palette.lmp");
    LevelScene level(argc > 2 ? argv[2] : assets + "/demo.bsp", palette, window.mode());
    Speaker speaker;
    if (!speaker.problem().empty()) std::fprintf(stderr, "%s\n", speaker.problem().c_str());
    speaker.play_music(assets + "/music/title.mod", 128);
    Pose eye = level.start();
    int rise = 0;  // 256ths of a unit a second
    std::int64_t shown_ms = 0;
    window.capture_mouse(true);
    do {
        const int passed_ms = static_cast<int>(std::min<std::int64_t>(window.time_ms() - shown_ms, 100));
        shown_ms = window.time_ms();
        eye = turned(eye, window, passed_ms);
        const int ahead =
                      pressure_256(window, "S", "W", "Left Stick Down", "Left Stick Up") * kSpeed * passed_ms / 1000,
                  right =
                      pressure_256(window, "A", "D", "Left Stick Left", "Left Stick Right") * kSpeed * passed_ms / 1000;
        if (level.stands(eye))
            rise = window.is_down("Space") ? kJump * 256 : std::max(rise, 0);
        else
            rise -= kGravity * 256 * passed_ms / 1000;
        eye = level.walked(eye, moved(eye, ahead, right, rise / 1000 * passed_ms));

        for (int door = -1; (door = level.find_entity("classname", "func_door_rotating", door)) >= 0;)
            level.turn_entity(door, window.pressure_256("E") * 90);
        if (window.was_pressed("F")) window.set_full_screen(true);
        if (window.was_pressed("M")) speaker.stop_music();
        if (window.was_pressed("Escape")) window.close();
        level.draw(eye, shown_ms, window.canvas());
        window.palette = level.palette_at(eye, shown_ms);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
