// Models without a level: one from a file, one made of triangles here, with ambient and directional light. A depth
// buffer decides which one is in front, in any order of drawing. S saves the picture. In the texts: Abrash on normals,
// the dot product and faces turned away; Princeton's illumination; the course notes' depth buffer, shading and
// textures.
//
// Usage: example_models [ASSETS]
#include <oblong.h>

#include <array>

using namespace oblong;

namespace {

constexpr int kBackground = 98;  // a dark blue

// Four sides that meet above the middle; their corners run clockwise seen from outside.
void add_pyramid(Model& model, const Picture& picture) {
    const int number = model.add_picture(picture), right = picture.width_px, bottom = picture.height_px;
    constexpr std::array<PixelPosition, 4> kGround{{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto [x, y] = kGround[i];
        const auto [next_x, next_y] = kGround[(i + 1) % 4];
        model.add_triangle({x, y, -16, 0, bottom}, {0, 0, 24, right / 2, 0}, {next_x, next_y, -16, right, bottom},
                           number);
    }
}

}  // namespace

int main(int argc, char** argv) try {
    const std::string assets = argc > 1 ? argv[1] : "build/assets";
    Window window("Models");
    window.palette = load_palette(assets + "/palette.lmp");
    const Model sphere(assets + "/models/armillary.obj", window.palette, 20 * 256);
    Model pyramid;
    add_pyramid(pyramid, load_picture(assets + "/models/brass.png", window.palette));
    Stage stage(window.palette, window.mode());
    stage.set_light(80, 240, -2, 1, 2);
    do {
        const Framebuffer canvas = window.canvas();
        clear(canvas, kBackground);
        stage.look(pose_at(-90, 0, 30, 0, 18), 70);
        Pose left = pose_at(0, 26, 0), right = pose_at(0, -34, -24);
        left.yaw_256 = static_cast<int>(window.time_ms() * 8 % (360 * 256));
        right.yaw_256 = -left.yaw_256;
        const auto frame = static_cast<int>(window.time_ms() / 100 % sphere.frame_count());
        stage.draw(pyramid, left, canvas);
        stage.draw(sphere, right, canvas, frame);
        if (window.was_pressed("S")) save_picture("models.png", canvas, window.palette);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
