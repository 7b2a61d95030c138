// A level with a door that this program moves. The values of an entity (its angle, its speed) are text to read; its
// brushes are solid wherever the program moves them. Arrow keys walk; both wings open when the player is near.
//
// Usage: example_door [ASSETS]
#include <oblong.h>

#include <algorithm>

using namespace oblong;

namespace {

constexpr int kOpen_256 = 44 * 256, kNear = 140;

struct Wing {
    int entity, angle, speed;  // degrees; units a second
};

Wing next_wing(const LevelScene& level, int after) {
    const int entity = level.find_entity("classname", "func_door", after);
    const auto number = [&](const char* key) { return std::stoi(level.entity_value(entity, key)); };
    return {entity, number("angle"), number("speed")};
}

Pose walked(const LevelScene& level, Pose eye, const Window& window, int passed_ms) {
    const auto pressed = [&](const char* plus, const char* minus) {
        return window.is_down(plus) - window.is_down(minus);
    };
    eye.yaw_256 += pressed("Left", "Right") * passed_ms * 30;
    return level.walked(eye, moved(eye, pressed("Up", "Down") * passed_ms * 50, 0, -passed_ms * 50));
}

}  // namespace

int main(int argc, char** argv) try {
    const std::string assets = argc > 1 ? argv[1] : "build/assets";
    Window window("Door");
    const Palette palette = load_palette(assets + "/palette.lmp");
    LevelScene level(assets + "/demo.bsp", palette, window.mode());
    const Model key(assets + "/models/key_gold.obj", palette, 20 * 256);
    Speaker speaker;
    const int sound = speaker.load(assets + "/sounds/door_start.flac");
    const Wing left = next_wing(level, -1), right = next_wing(level, left.entity);
    const Pose middle = pose_at(1328, 416, 80);
    Pose eye = pose_at(1242, 416, 47);
    int open_256 = 0;
    std::int64_t shown_ms = 0;
    do {
        const int passed_ms = static_cast<int>(std::min<std::int64_t>(window.time_ms() - shown_ms, 100));
        shown_ms = window.time_ms();
        eye = walked(level, eye, window, passed_ms);
        const bool is_near = std::abs(eye.x_256 - middle.x_256) + std::abs(eye.y_256 - middle.y_256) < kNear * 256;
        if (is_near && open_256 == 0) speaker.play(sound);
        const int way_256 = left.speed * 256 * passed_ms / 1000;
        open_256 = std::clamp(open_256 + (is_near ? way_256 : -way_256), 0, kOpen_256);
        for (const Wing& wing : {left, right}) {
            const Pose away = moved(pose_at(0, 0, 0, wing.angle), open_256, 0);
            level.move_entity(wing.entity, away.x_256, away.y_256, 0);
        }
        // A sign that turns above the door until it's open.
        Pose sign = middle;
        sign.yaw_256 = static_cast<int>(shown_ms % 4000) * 23;
        if (open_256 < kOpen_256) level.show(key, sign);
        level.draw(eye, shown_ms, window.canvas());
        window.palette = level.palette_at(eye, shown_ms);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
