// A cube step by step: corners in object space, rotated and placed in the world, seen from an eye there, and projected
// to the screen by a division and two multipliers. P: parallel projection, P and O: oblique. Arrow keys move the eye.
// In the texts: the lab's and Princeton's projections; the notes' matrices; Abrash's "Rotation by Projection";
// Muratori's multipliers.
#include <oblong.h>

using namespace oblong;

namespace {

constexpr int kOne = 4096, kEyeYaw_256 = 10 * 256, kMarked = 3;  // one unit; degrees; the labelled corner

struct Point {
    int x, y, z;  // right, up, ahead
};

// The coordinates after rotating two axes from the first to the second: each is a projection onto an axis.
void turn(int& first, int& second, std::int64_t angle_256) {
    const std::int64_t sine = sine_65536(angle_256), cosine = sine_65536(angle_256 + 90 * 256), a = first, b = second;
    first = static_cast<int>((a * cosine + b * sine) >> 16);
    second = static_cast<int>((b * cosine - a * sine) >> 16);
}

Point to_world(Point object, std::int64_t time_ms) {
    turn(object.x, object.z, time_ms * 5);
    turn(object.y, object.z, 25 * 256);
    return {object.x, object.y, object.z + 5 * kOne};
}

Point to_view(const Point& world, const Point& eye) {
    Point view{world.x - eye.x, world.y - eye.y, world.z - eye.z};
    turn(view.z, view.x, kEyeYaw_256);
    return view;
}

PixelPosition to_screen(Point view, const Window& window) {
    const ScreenMode& mode = window.mode();
    const int middle = 5 * kOne, depth = window.is_down("P") ? middle : view.z;
    if (window.is_down("O")) view.x += (view.z - middle) / 3, view.y += (view.z - middle) / 3;
    const auto [width, height] = mode.pixel();  // 5 to 6
    const std::int64_t across = mode.width_px;  // the edge of the screen is half as far to the side as away: 53 degrees
    return {static_cast<int>(mode.width_px / 2 + across * view.x / depth),
            static_cast<int>(mode.height_px / 2 - across * width * view.y / (height * depth))};
}

std::string text_of(const Point& at) {
    const auto hundredths = [](int length) { return " " + std::to_string(length * 100 / kOne); };
    return hundredths(at.x) + hundredths(at.y) + hundredths(at.z);
}

}  // namespace

int main() try {
    Window window("Cube");
    window.palette.colours = {{{10, 14, 30}, {120, 220, 200}, {255, 220, 140}}};
    Point eye{-kOne, 0, 0};
    do {
        eye.x += 64 * (window.is_down("Right") - window.is_down("Left"));
        eye.y += 64 * (window.is_down("Up") - window.is_down("Down"));
        const Framebuffer canvas = window.canvas();
        clear(canvas);
        PixelPosition corners[8];
        for (unsigned i = 0; i < 8; ++i) {
            const Point object{i & 1 ? kOne : -kOne, i & 2 ? kOne : -kOne, i & 4 ? kOne : -kOne};
            const Point world = to_world(object, window.time_ms()), view = to_view(world, eye);
            const PixelPosition at = corners[i] = to_screen(view, window);
            if (i != kMarked) continue;
            draw_label(canvas, 4, 4, "object" + text_of(object), 2);
            draw_label(canvas, 4, 14, "world " + text_of(world), 2);
            draw_label(canvas, 4, 24, "view  " + text_of(view), 2);
            draw_label(canvas, at.column + 4, at.row - 4, std::to_string(at.column) + " " + std::to_string(at.row), 2);
        }
        for (unsigned i = 0; i < 8; ++i)
            for (const PixelPosition next : {corners[i | 1], corners[i | 2], corners[i | 4]})
                draw_line(canvas, corners[i].column, corners[i].row, next.column, next.row, 1);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
