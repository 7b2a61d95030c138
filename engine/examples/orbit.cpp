// A viewer of models: the left button turns about the middle of the model's box, the wheel comes nearer, E shows edges,
// L moves the light. Labels stand where the axes end in the picture.
//
// Usage: example_orbit [ASSETS [MODEL.obj]]
#include <oblong.h>

#include <algorithm>
#include <array>
#include <string>

using namespace oblong;

namespace {

constexpr int kEdges = 229, kInk = 14, kFieldOfView = 60;

// The eye at a distance from a place that it looks at.
Pose around(const Pose& middle, int yaw_256, int pitch_256, int distance_256) {
    const int flat = static_cast<int>(std::int64_t{sine_65536(pitch_256 + 90 * 256)} * distance_256 >> 16),
              up = static_cast<int>(std::int64_t{sine_65536(pitch_256)} * distance_256 >> 16);
    Pose eye = middle;
    eye.yaw_256 = yaw_256;
    eye = moved(eye, -flat, 0, up);
    eye.pitch_256 = pitch_256;
    return eye;
}

void draw_axes(Framebuffer canvas, const ScreenMode& mode, const Pose& eye, int length_256) {
    const std::array<Pose, 3> ends{{{length_256, 0, 0}, {0, length_256, 0}, {0, 0, length_256}}};
    const auto origin = project({}, eye, mode, kFieldOfView);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto end = project(ends[i], eye, mode, kFieldOfView);
        if (!origin || !end) continue;
        draw_line(canvas, origin->column, origin->row, end->column, end->row, kInk);
        draw_label(canvas, end->column + 2, end->row - 4, std::string(1, static_cast<char>('x' + i)), kInk);
    }
}

}  // namespace

int main(int argc, char** argv) try {
    const std::string assets = argc > 1 ? argv[1] : "build/assets";
    Window window("Orbit");
    window.palette = load_palette(assets + "/palette.lmp");
    // Faces without a material get the picture of brass.
    const Model model(argc > 2 ? argv[2] : assets + "/models/armillary.obj", window.palette, 20 * 256,
                      {.picture = load_picture(assets + "/models/brass.png", window.palette)});
    const auto [least, greatest] = model.bounds();
    const Pose middle{(least.x_256 + greatest.x_256) / 2, (least.y_256 + greatest.y_256) / 2,
                      (least.z_256 + greatest.z_256) / 2};
    const int size_256 =
        std::max({greatest.x_256 - least.x_256, greatest.y_256 - least.y_256, greatest.z_256 - least.z_256});
    Stage stage(window.palette);
    int yaw_256 = 215 * 256, pitch_256 = 25 * 256, distance_256 = size_256 * 3 / 2, light = 0;
    bool has_edges = false;
    PixelPosition before;
    do {
        const Framebuffer canvas = window.canvas();
        const auto [column, row] = window.mouse();
        if (window.is_down("Mouse 1") && !window.was_pressed("Mouse 1")) {
            yaw_256 -= (column - before.column) * 200;
            pitch_256 = std::clamp(pitch_256 + (row - before.row) * 200, -89 * 256, 89 * 256);
        }
        before = {column, row};
        distance_256 += distance_256 / 10 * (window.press_count("Wheel Down") - window.press_count("Wheel Up"));
        has_edges ^= window.was_pressed("E");
        light += window.is_down("L") ? 3 : 0;
        const Pose eye = around(middle, yaw_256, pitch_256, distance_256);
        clear(canvas, 98);
        stage.set_light(90, 230, sine_65536((light + 130) * 256) / 256, sine_65536((light + 40) * 256) / 256, 200);
        stage.look(eye, kFieldOfView);
        stage.draw(model, {}, canvas);
        if (has_edges) stage.draw_edges(model, {}, kEdges, canvas);
        draw_axes(canvas, window.mode(), eye, size_256 / 2);
        draw_label(canvas, 6, 188, "turn: left button   nearer: wheel   E: edges", kInk);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
