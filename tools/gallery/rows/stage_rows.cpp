// The pipeline, stopped after each stage: a cube by the functions that draw models, with the numbers after each stage.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/methods/polygons.h"
#include "engine/methods/transforms.h"
#include "engine/raster/lines.h"
#include "tools/gallery/row.h"
#include "tools/gallery/sketch.h"
#include "tools/gallery/staged_cube.h"

namespace oblong {

namespace {

constexpr std::array<std::array<std::uint32_t, 2>, 12> kEdges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// The eye looks east, and down with slope 1/2: forward is (kLevel, 0, -kDown), up is (kDown, 0, kLevel).
const double kLevel = 2 / std::sqrt(5.0), kDown = 1 / std::sqrt(5.0);

/// The world point with these viewspace coordinates.
Vec3<World> point_before_eye(double right, double up, double ahead) {
    return world_point(ahead * kLevel + up * kDown, -right, up * kLevel - ahead * kDown);
}

/// The triangles that face the eye, lit or in plain colours: from `from`, back ones first.
void draw_sides(const StagedCube& cube, Stage stage, std::span<const Vec3<World>> places, const Vec3<World>& from,
                const GalleryAssets& assets, Sketch& sketch) {
    for (const bool is_front : {false, true})
        for (const ShownTriangle& shown : cube.triangles) {
            std::array<Vec3<World>, 3> corners;
            for (std::size_t i = 0; i < 3; ++i)
                corners[i] = item(places, cube.mesh.triangles[shown.number].vertices[i]);
            const Vec3<Unit> normal = normalised(cross(corners[2] - corners[0], corners[1] - corners[0]));
            if (faces_away(corners[0], normal, from) == is_front) continue;
            const auto part = [&](int full) { return static_cast<int>(full * std::min(shown.light / 150, 1.0)); };
            sketch.polygon(corners, stage == Stage::Lit ? assets.colour(part(230), part(160), part(70))
                                    : is_front          ? assets.colour(90, 110, 150)
                                                        : assets.colour(52, 62, 88));
        }
}

/// The cube in its own space, or in the world with the eye and its view, from outside.
void draw_from_outside(const StagedCube& cube, Stage stage, const RowInput& input, Framebuffer canvas,
                       const Area& area) {
    const GalleryAssets& assets = input.assets;
    const bool is_object = stage <= Stage::Facing;
    const SketchEye from = stage == Stage::Object   ? SketchEye{world_point(5, -6, 4), world_point(0, 0, 0), 40}
                           : stage == Stage::Facing ? SketchEye{world_point(1, -10, 7), world_point(-1, -1, 0.8), 42}
                           : stage == Stage::Lit    ? SketchEye{world_point(1, -5, 1.5), world_point(3.8, 1.2, -1), 46}
                                                    : SketchEye{world_point(-5, -9, 4), world_point(2.6, 0, -1.5), 46};
    Sketch sketch(input, canvas, area, from);
    std::vector<Vec3<World>> places;
    for (std::uint32_t i = 0; i < 8; ++i)
        places.push_back(is_object ? cube.mesh.frames[0].vertices[i].position
                                   : cube.scratch.world_vertices[i].position);
    const auto place = [&](std::uint32_t i) { return places[i]; };
    if (stage == Stage::Facing || stage == Stage::Lit) draw_sides(cube, stage, places, from.eye, assets, sketch);
    const std::uint8_t grey = assets.colour(80, 88, 110);
    // In view space x is right, y up, z ahead.
    const std::array axes =
        stage == Stage::InView
            ? std::array{point_before_eye(2.2, 0, 0), point_before_eye(0, 2.2, 0), point_before_eye(0, 0, 2.2)}
            : std::array{world_point(2.2, 0, 0), world_point(0, 2.2, 0), world_point(0, 0, 2.2)};
    sketch.axes(axes, assets);
    if (stage == Stage::Facing) {
        const std::uint8_t white = assets.colour(235, 235, 225);
        sketch.line(cube.object_eye, world_point(0, 0, 0), grey);
        sketch.label(cube.object_eye, "eye", white);
    }
    if (stage == Stage::Lit) {
        const std::uint8_t yellow = assets.colour(250, 230, 120);
        const Vec3<Unit>& toward = cube.light.directional.toward;
        const Vec3<World> top = cube.placed.position + world_point(0, 0, 1);
        const Vec3<World> lamp = top + world_point(vec_of(toward) * 2);
        sketch.line(top, lamp, yellow);
        sketch.label(lamp, "to the light", yellow);
    }
    if (!is_object) {
        const double across = 7 * std::tan(30 * std::numbers::pi / 180),
                     up = across * area.height / area.width * number_of(input.mode.pixel().inverse());
        const std::array far{point_before_eye(-across, up, 7), point_before_eye(across, up, 7),
                             point_before_eye(across, -up, 7), point_before_eye(-across, -up, 7)};
        sketch.outline(far, grey);
        for (const Vec3<World>& corner : far) sketch.line(world_point(0, 0, 0), corner, grey);
        sketch.label(world_point(0, 0, 0), "eye", assets.colour(235, 235, 225));
    }
    for (const auto& [a, b] : kEdges) sketch.line(place(a), place(b), assets.colour(240, 190, 90));
    const bool shows_sides = stage == Stage::Facing || stage == Stage::Lit;
    for (std::uint32_t i = 0; i < 8 && !shows_sides; ++i)
        sketch.label(place(i), std::to_string(i), assets.colour(235, 235, 225));
}

PixelPosition pixel_of(const ScreenVertex& vertex) {
    return {floor_of(vertex.x), floor_of(vertex.y)};
}

/// The cube seen from the eye: outlines of the clipped triangles, spans, pixels.
void draw_from_eye(const StagedCube& cube, Stage stage, const RowInput& input, Framebuffer part) {
    const GalleryAssets& assets = input.assets;
    if (stage == Stage::Pixels) {
        DepthBuffer depth(part.width_px, part.height_px);
        const ScreenRectangle all{0, part.width_px, 0, part.height_px};
        depth.start_frame();
        depth.want(all);
        depth.clear();
        MeshScratch scratch(part.height_px);
        draw_mesh(cube.placed, {cube.view, assets.colormap, cube.light}, {depth, part, all}, scratch);
        return;
    }
    const std::array<std::uint8_t, 2> colours{assets.colour(90, 130, 220), assets.colour(70, 105, 180)};
    for (const ShownTriangle& triangle : cube.triangles) {
        for (const Span& span : triangle.spans) {
            if (stage == Stage::Spans && span.y % 2 == 0) continue;  // so that spans can be told apart
            if (stage == Stage::Spans)
                fill_area(part, {span.first, span.y, span.end - span.first, 1}, item(colours, triangle.number % 2));
            if (stage != Stage::Scanned) continue;
            set_pixel(part, span.first, span.y, assets.colour(110, 200, 110));
            set_pixel(part, span.end - 1, span.y, assets.colour(220, 90, 80));
        }
        if (stage > Stage::Projected) continue;
        for (std::size_t i = 0; i < triangle.corners.size(); ++i) {
            const ScreenVertex &a = triangle.corners[i].screen,
                               &b = triangle.corners[(i + 1) % triangle.corners.size()].screen;
            draw_line(pixel_of(a), pixel_of(b), {LineMethod::Bresenham, assets.colour(240, 190, 90)}, part);
            if (stage == Stage::Projected) {
                const PixelPosition p = pixel_of(a);
                fill_area(part, {p.column - 1, p.row - 1, 3, 3}, assets.colour(110, 200, 110));
            }
        }
    }
}

/// The canonical volume from its front, -1 to 1 across and up, whatever the screen's shape: the clipped triangles after
/// the perspective divide.
void draw_divided(const StagedCube& cube, const RowInput& input, Framebuffer canvas, const Area& area) {
    Diagram diagram(input, part_of(canvas, {0, 0, area.width, canvas.height_px}), {0, 0}, 2.5);
    const std::uint8_t grey = input.colour(80, 88, 110);
    diagram.line({-1.2, 0}, {1.2, 0}, grey);
    diagram.line({0, -1.2}, {0, 1.2}, grey);
    diagram.outline({-1, -1}, {1, 1}, input.colour(90, 130, 220));
    diagram.text({-1, -1}, "-1", input.colour(90, 130, 220), -14, 0);
    diagram.text({1, 1}, "1", input.colour(90, 130, 220), 3, -4);
    const auto flat = [](const Vec3<Entry>& corner) { return PlanePoint{number_of(corner.x), number_of(corner.y)}; };
    for (const ShownTriangle& triangle : cube.triangles)
        for (std::size_t i = 0; i < triangle.divided.size(); ++i) {
            diagram.line(flat(triangle.divided[i]), flat(triangle.divided[(i + 1) % triangle.divided.size()]),
                         input.colour(240, 190, 90));
            diagram.disc(flat(triangle.divided[i]), 0.03, input.colour(110, 200, 110));
        }
}

/// The largest distance between the divided vertices after the viewport transform and the next stage's screen
/// positions, of vertices in the view.
double viewport_error_px(const StagedCube& cube, Framebuffer part) {
    double worst = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        const ViewVertex& vertex = cube.scratch.view_vertices[i];
        if (vertex.outcode != 0) continue;
        const Vec3<World>& p = cube.scratch.world_vertices[i].position;
        const Vec3<Entry> divided = *point_of(cube.to_volume() * homogeneous(p));
        worst = std::max({worst, std::abs((1 + number_of(divided.x)) / 2 * part.width_px - number_of(vertex.screen.x)),
                          std::abs((1 - number_of(divided.y)) / 2 * part.height_px - number_of(vertex.screen.y))});
    }
    return worst;
}

/// A vertex in the world, by sines and cosines in double.
std::array<double, 3> world_in_double(const RowInput& input, int vertex) {
    const double yaw = input.radians(1);
    const double x = vertex & 1 ? 1 : -1, y = vertex & 2 ? 1 : -1, z = vertex & 4 ? 1 : -1;
    return {kCubeAhead + x * std::cos(yaw) - y * std::sin(yaw),
            input.number(2) / 4 + x * std::sin(yaw) + y * std::cos(yaw), z + kCubeBelow};
}

/// The triangles that face an eye at the origin: two for each side whose plane is between it and the cube.
int facing_in_double(const RowInput& input) {
    const double yaw = input.radians(1);
    const double x = -kCubeAhead, y = -input.number(2) / 4;
    const double own_x = x * std::cos(yaw) + y * std::sin(yaw), own_y = y * std::cos(yaw) - x * std::sin(yaw);
    return 2 * ((std::abs(own_x) > 1) + (std::abs(own_y) > 1) + (std::abs(kCubeBelow) > 1));
}

/// The light of those triangles: 40 plus 110 times the cosine between a side's normal and (-2, -1, 2), of length 3.
double light_in_double(const RowInput& input) {
    const double yaw = input.radians(1);
    const double x = -kCubeAhead, y = -input.number(2) / 4;
    const double own_x = x * std::cos(yaw) + y * std::sin(yaw), own_y = y * std::cos(yaw) - x * std::sin(yaw);
    const auto side = [](double normal_x, double normal_y, double normal_z) {
        return 40 + 110 * std::max((-2 * normal_x - normal_y + 2 * normal_z) / 3, 0.0);
    };
    double light = 2 * side(0, 0, 1);  // the eye is above the cube
    const double east = std::copysign(1, own_x), north = std::copysign(1, own_y);
    if (std::abs(own_x) > 1) light += 2 * side(east * std::cos(yaw), east * std::sin(yaw), 0);
    if (std::abs(own_y) > 1) light += 2 * side(-north * std::sin(yaw), north * std::cos(yaw), 0);
    return light;
}

Figures draw_stages(const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    fill(canvas, assets.colour(18, 22, 34));
    const auto stage = static_cast<Stage>(input.values[0]);
    const Area area = scene_area(canvas, 188);
    const Framebuffer part = part_of(canvas, area);
    const StagedCube cube(input, part);
    if (stage <= Stage::InView)
        draw_from_outside(cube, stage, input, canvas, area);
    else if (stage == Stage::Divided)
        draw_divided(cube, input, canvas, area);
    else
        draw_from_eye(cube, stage, input, part);
    draw_column(canvas, canvas.width_px * 190 / 320, kHeader_px + 3, cube.lines_of(stage), assets.text);

    const auto world = world_in_double(input, 0);
    const ViewVertex& vertex = cube.scratch.view_vertices[0];
    std::int64_t span_pixels = 0;
    double light = 0;
    for (const ShownTriangle& triangle : cube.triangles) {
        light += triangle.light;
        for (const Span& span : triangle.spans) span_pixels += span.end - span.first;
    }
    const Vec3<World>& first = cube.scratch.world_vertices[0].position;
    const Vec3<Entry> divided = *point_of(cube.to_volume() * homogeneous(first));
    const double ahead = world[0] * kLevel - world[2] * kDown;
    // Both round in view space: 1/100 pixel in 320x200, and in proportion in larger pictures.
    const double rounding_px = 0.01 * std::max({1.0, part.width_px / 188.0, part.height_px / 154.0});
    return {
        count_figure("triangles that face the eye", facing_in_double(input), std::ssize(cube.triangles)),
        number_figure("vertex 0 in the world: y", world[1], number_of(cube.scratch.world_vertices[0].position.y), 1e-3),
        number_figure("vertex 0 in view space: x, to the right", -world[1], number_of(vertex.position.x), 2e-3),
        number_figure("vertex 0 in view space: y, up", world[0] * kDown + world[2] * kLevel,
                      number_of(vertex.position.y), 2e-3),
        number_figure("vertex 0 in view space: z, ahead", ahead, number_of(vertex.position.z), 2e-3),
        number_figure("light of all that face it, by cosines", light_in_double(input), light, 0.1, 1),
        number_figure("vertex 0 divided: x / (z tan 30)", -world[1] / (ahead * std::tan(std::numbers::pi / 6)),
                      number_of(divided.x), 1e-3),
        number_figure("its depth: f / (f - n) (1 - n / z)",
                      kVolumeFar / (kVolumeFar - kVolumeNear) * (1 - kVolumeNear / ahead), number_of(divided.z), 1e-4),
        number_figure("pixels from there to the screen's corners", 0, viewport_error_px(cube, part), rounding_px),
        measured("pixels of all spans", span_pixels)};
}

}  // namespace

std::vector<Row> stage_rows() {
    return {{"pipeline",
             draw_stages,
             {choice_parameter("stage", kStageNames),
              {"yaw, degrees", 0, 85, 5, 60},
              {"to the left, quarters of a unit", -10, 10, 1, 7}}}};
}

}  // namespace oblong
