// Seeds 3 and 5: a model in the pipeline, and among the surfaces of a level.

#include "engine/frame/frame_counts.h"
#include "tools/gallery/mesh_scene.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

MeshLight light_from_above() {
    return {50, {unit_vector({-1, -1, 2}), 90}, {}, 100};
}

constexpr double kHalfCube = 30;
constexpr int kPitchDegrees = 25;

/// The number of sides of a turned cube that face the eye, which is `distance` from its middle.
std::int64_t sides_in_front(double distance, double yaw, double pitch) {
    // The x components of its axes: ahead, left, up.
    const std::array towards{std::cos(pitch) * std::cos(yaw), -std::sin(yaw), std::sin(pitch) * std::cos(yaw)};
    return std::count_if(towards.begin(), towards.end(),
                         [distance](double x) { return distance * std::abs(x) > kHalfCube; });
}

Figures draw_cube(const RowInput& input, Canvas& canvas) {
    canvas.fill(kGround);
    const Mesh cube = cube_mesh(kHalfCube, checkered_skin(64, lit_colour(input.assets, {190, 150, 90}),
                                                          lit_colour(input.assets, {120, 60, 40})));
    PlacedMesh placed;
    placed.mesh = &cube;
    placed.shading = Shading::Flat;
    placed.position = world_point(input.number(1), 0, 0);
    placed.yaw = input.angle(0);
    placed.pitch = degrees_to_angle(Degrees::from_int(-kPitchDegrees));
    const Picture covered(canvas.width_px, canvas.height_px, 255);
    MeshScene(input, canvas).draw(placed, light_from_above());
    const Colormap numbers = shade_numbers();
    const MeshCounts counts = MeshScene(input, covered).draw(placed, light_from_above(), &numbers);
    const std::vector<std::uint8_t> none(covered.indices.size(), 255);
    return {{"triangles that face the eye, of 12",
             2 * sides_in_front(input.number(1), input.radians(0), -kPitchDegrees * kDegree), counts.facing},
            {"pixels drawn: each once", count_differences(covered.indices, none), counts.pixels},
            {"triangles with pixels, after clipping to the view", counts.triangles}};
}

Figures draw_in_level(const RowInput& input, Canvas& canvas) {
    const Mesh ball = ball_mesh(
        30, 16, checkered_skin(64, lit_colour(input.assets, {200, 190, 170}), lit_colour(input.assets, {60, 80, 130})));
    PlacedMesh placed;
    placed.mesh = &ball;
    placed.shading = static_cast<Shading>(input.values[1]);
    placed.highlight = 60;
    placed.position = world_point(input.number(0), 420, 60);
    placed.yaw = Angle::from_bam(input.time_ms * 8);
    DemoFrame frame(input, input.mode);
    FrameCounts counts;
    frame.work.observers.counts = &counts;
    const auto drawn_with_depth = [&](Framebuffer picture) {
        frame.draw(camera_at(0, 120, 70, 90, 0, 70), picture);
        std::int64_t pixels = 0;
        for (const ScreenRectangle& part : frame.work.view.depth.rectangles())
            pixels += std::int64_t{part.end_column - part.first_column} * (part.end_row - part.first_row);
        return pixels;
    };
    const std::int64_t before = drawn_with_depth(Picture(canvas.width_px, canvas.height_px));
    frame.scene.meshes = {&placed, 1};
    const std::int64_t after = drawn_with_depth(canvas);
    return {{"pixels with depth in a frame without it", 0, before},
            {"pixels with depth: the rectangle around it", after},
            {"pixels that it owns", counts.of(Effect::Meshes)}};
}

}  // namespace

std::vector<Row> mesh_rows() {
    return {{"mesh-pipeline", draw_cube, {{"turn, degrees", 0, 355, 5, 30}, {"distance", 32, 400, 8, 160}}},
            {"mesh-in-level",
             draw_in_level,
             {{"x", -200, 200, 10, -70}, choice_parameter("shading", {"flat", "Gouraud", "Phong"}, 1)}}};
}

}  // namespace oblong
