// The pipeline, stopped after each stage: a cube by the functions that draw models, with the numbers that each leaves.

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/fixed/trig.h"
#include "engine/geometry/views.h"
#include "engine/mesh/draw_mesh.h"
#include "engine/raster/lines.h"
#include "engine/raster/scan.h"
#include "tools/common/font.h"
#include "tools/gallery/rows.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

enum class Stage { Object, World, View, Clipped, Projected, Scanned, Spans, Pixels };
const std::vector<std::string> kStageNames{"object space", "world space", "view space", "clipped",
                                           "projected",    "scanned",     "spans",      "pixels"};

/// A cube of 2 units, a triangle on each half of a side: corners counted as bits (x, y, z), sides counter-clockwise
/// from outside, and the triangles clockwise.
Mesh make_cube() {
    Mesh cube;
    MeshFrame frame;
    for (int i = 0; i < 8; ++i)
        frame.vertices.push_back({world_point(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1), {}});
    constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {4, 5, 7, 6}, {0, 2, 3, 1}}};
    std::vector<std::array<std::uint32_t, 3>> corners;
    for (const auto& side : kSides) {
        cube.triangles.push_back({{side[0], side[2], side[1]}, 0});
        cube.triangles.push_back({{side[0], side[3], side[2]}, 0});
    }
    for (const MeshTriangle& triangle : cube.triangles) corners.push_back(triangle.vertices);
    set_normals(frame.vertices, corners);
    set_box(frame);
    cube.frames.push_back(frame);
    cube.texels.assign(8, {});
    return cube;
}

constexpr std::array<std::array<std::uint32_t, 2>, 12> kEdges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// A triangle on its way: what clipping and the scan converter made of it.
struct ShownTriangle {
    std::uint32_t number = 0;
    std::vector<ScreenCorner> corners;
    std::vector<Span> spans;
};

/// The cube's place: so far ahead of the eye, and below it.
constexpr double kAhead = 5.6, kBelow = -1.3;

/// All that the stages leave of the cube, by the engine's own functions in their order.
struct StagedCube {
    StagedCube(const RowInput& input, Framebuffer part);

    Mesh mesh = make_cube();
    PlacedMesh placed;
    ViewContext view;
    MeshScratch scratch;
    std::vector<ShownTriangle> triangles;
};

/// The mode of a part of the picture, with pixels of the same shape.
ScreenMode mode_of(const RowInput& input, Framebuffer part) {
    return {part.width_px, part.height_px, input.mode.pixel() * Ratio{part.width_px, part.height_px}};
}

StagedCube::StagedCube(const RowInput& input, Framebuffer part) : scratch(part.height_px) {
    placed.mesh = &mesh;
    placed.position = world_point(kAhead, static_cast<double>(input.values[2]) / 4, kBelow);
    placed.yaw = degrees_to_angle(Degrees::from_int(input.values[1]));
    placed.colour = input.assets.colour(230, 160, 70);
    placed.shading = Shading::Flat;
    view = make_view_context(look_at_view({}, world_point(1, 0, 0), Degrees::from_int(60)), mode_of(input, part));
    const MeshTransform transform = *make_mesh_transform(placed);
    const auto object = pose_of(placed, scratch.object_vertices);
    find_facing(mesh.triangles, object, to_object(view.eye, transform), scratch.facing);
    transform_to_world(object, transform, scratch.world_vertices);
    transform_to_view(scratch.world_vertices, view, scratch.view_vertices);
    find_corner_values(placed, scratch.world_vertices, {}, scratch.values);
    for (const std::uint32_t number : scratch.facing) {
        std::array<const ViewVertex*, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) corners[i] = &at(scratch.view_vertices, mesh.triangles[number].vertices[i]);
        ShownTriangle shown{number, {}, {}};
        clip_and_project(corners, {}, view, scratch.clip, shown.corners);
        std::vector<ScreenVertex> polygon;
        for (const ScreenCorner& corner : shown.corners) polygon.push_back(corner.screen);
        if (polygon.size() >= 3) {
            scan_convex(polygon, scratch.rows);
            append_spans(scratch.rows, {0, part.width_px, 0, part.height_px}, shown.spans);
        }
        triangles.push_back(std::move(shown));
    }
}

std::string row_of(const char* format, double a, double b, double c) {
    char text[64];
    std::snprintf(text, sizeof text, format, a, b, c);
    return text;
}

std::string outcode_letters(unsigned outcode) {
    constexpr std::array<char, 5> kLetters{'L', 'R', 'B', 'T', 'Z'};
    std::string text;
    for (std::size_t i = 0; i < kLetters.size(); ++i)
        if (outcode >> i & 1) text += kLetters[i];
    return text.empty() ? "-" : text;
}

template <class T>
std::string place_text(const Vec3<T>& p) {
    return row_of("%6.2f%6.2f%6.2f", number_of(p.x), number_of(p.y), number_of(p.z));
}

/// The numbers that a stage leaves.
std::vector<std::string> numbers_of(const StagedCube& cube, Stage stage) {
    std::vector<std::string> lines;
    if (stage == Stage::Object)
        for (const MeshVertex& vertex : cube.mesh.frames[0].vertices) lines.push_back(place_text(vertex.position));
    if (stage == Stage::World)
        for (const WorldVertex& vertex : cube.scratch.world_vertices) lines.push_back(place_text(vertex.position));
    if (stage == Stage::View)
        for (const ViewVertex& vertex : cube.scratch.view_vertices)
            lines.push_back(place_text(vertex.position) + " " + outcode_letters(vertex.outcode));
    for (const ShownTriangle& triangle : cube.triangles) {
        const std::string number = std::to_string(triangle.number);
        const std::size_t corners = triangle.corners.size();
        if (stage == Stage::Clipped) lines.push_back("triangle " + number + ": " + std::to_string(corners));
        if (stage == Stage::Projected)
            for (const ScreenCorner& corner : triangle.corners)
                lines.push_back(row_of("%6.1f%6.1f%7.2f", number_of(corner.screen.x), number_of(corner.screen.y),
                                       1 / number_of(corner.inverse_z)));
        if (stage < Stage::Scanned || triangle.spans.empty()) continue;
        std::int64_t pixels = 0;
        for (const Span& span : triangle.spans) pixels += span.end - span.first;
        if (stage == Stage::Scanned)
            lines.push_back(number + ": rows " + std::to_string(triangle.spans.front().y) + " to " +
                            std::to_string(triangle.spans.back().y));
        if (stage == Stage::Spans) {
            const Span& middle = triangle.spans[triangle.spans.size() / 2];
            lines.push_back(number + ": " + std::to_string(middle.y) + ", " + std::to_string(middle.first) + "-" +
                            std::to_string(middle.end - 1));
        }
        if (stage == Stage::Pixels) lines.push_back(number + ": " + std::to_string(pixels) + " pixels");
    }
    return lines;
}

const char* caption_of(Stage stage) {
    constexpr std::array<const char*, 8> kCaptions{
        "  x     y     z",    "  x     y     z", "  x     y     z  out", "corners left",
        "column  row  depth", "first, last row", "middle row's span",    "drawn"};
    return at(kCaptions, stage);
}

/// The cube in its own space, or in the world with the eye and its view, from outside.
void draw_from_outside(const StagedCube& cube, Stage stage, const RowInput& input, Framebuffer canvas,
                       const Area& area) {
    const GalleryAssets& assets = input.assets;
    const bool is_object = stage == Stage::Object;
    const SketchEye from = is_object ? SketchEye{world_point(5, -6, 4), world_point(0, 0, 0), 40}
                                     : SketchEye{world_point(-3, -10, 5), world_point(3.6, 0, -0.4), 46};
    Sketch sketch(input, canvas, area, from);
    const auto place = [&](std::uint32_t i) {
        return is_object ? cube.mesh.frames[0].vertices[i].position : cube.scratch.world_vertices[i].position;
    };
    const std::uint8_t grey = assets.colour(80, 88, 110);
    // In view space x is right, y up, z ahead.
    const std::array axes = stage == Stage::View
                                ? std::array{world_point(0, -2.2, 0), world_point(0, 0, 2.2), world_point(2.2, 0, 0)}
                                : std::array{world_point(2.2, 0, 0), world_point(0, 2.2, 0), world_point(0, 0, 2.2)};
    const std::array<std::uint8_t, 3> colours{assets.colour(200, 80, 70), assets.colour(90, 170, 80),
                                              assets.colour(90, 130, 220)};
    constexpr std::array<const char*, 3> kAxisNames{"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
        sketch.line(world_point(0, 0, 0), axes[i], colours[i]);
        sketch.label(axes[i], kAxisNames[i], colours[i]);
    }
    if (!is_object) {
        const double across = 7 * std::tan(30 * std::numbers::pi / 180),
                     up = across * area.height / area.width * static_cast<double>(input.mode.pixel().denominator) /
                          static_cast<double>(input.mode.pixel().numerator);
        const std::array far{world_point(7, across, up), world_point(7, -across, up), world_point(7, -across, -up),
                             world_point(7, across, -up)};
        sketch.outline(far, grey);
        for (const Vec3<World>& corner : far) sketch.line(world_point(0, 0, 0), corner, grey);
        sketch.label(world_point(0, 0, 0), "eye", assets.colour(235, 235, 225));
    }
    for (const auto& [a, b] : kEdges) sketch.line(place(a), place(b), assets.colour(240, 190, 90));
    for (std::uint32_t i = 0; i < 8; ++i) sketch.label(place(i), std::to_string(i), assets.colour(235, 235, 225));
}

PixelPosition pixel_of(const ScreenVertex& vertex) {
    return {floor_of(vertex.x), floor_of(vertex.y)};
}

/// The cube as the eye sees it: outlines of what is left of its triangles, spans, pixels.
void draw_from_eye(const StagedCube& cube, Stage stage, const RowInput& input, Framebuffer part) {
    const GalleryAssets& assets = input.assets;
    if (stage == Stage::Pixels) {
        DepthBuffer depth(part.width_px, part.height_px);
        const ScreenRectangle all{0, part.width_px, 0, part.height_px};
        depth.start_frame();
        depth.want(all);
        depth.clear();
        MeshLight light;
        light.ambient = 40;
        light.directional = {normalised(world_point(-2, -1, 2)), 110};
        MeshScratch scratch(part.height_px);
        draw_mesh(cube.placed, {cube.view, assets.colormap, light}, {depth, part, all}, scratch);
        return;
    }
    const std::array<std::uint8_t, 2> colours{assets.colour(90, 130, 220), assets.colour(70, 105, 180)};
    for (const ShownTriangle& triangle : cube.triangles) {
        for (const Span& span : triangle.spans) {
            if (stage == Stage::Spans && span.y % 2 == 0) continue;  // so that one is told from the next
            if (stage == Stage::Spans)
                fill_area(part, {span.first, span.y, span.end - span.first, 1}, at(colours, triangle.number % 2));
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

/// A vertex by sines and cosines in double: world, and relative to the eye (right, up, ahead).
std::array<double, 3> world_in_double(const RowInput& input, int vertex) {
    const double yaw = static_cast<double>(input.values[1]) * std::numbers::pi / 180;
    const double x = vertex & 1 ? 1 : -1, y = vertex & 2 ? 1 : -1, z = vertex & 4 ? 1 : -1;
    return {kAhead + x * std::cos(yaw) - y * std::sin(yaw),
            static_cast<double>(input.values[2]) / 4 + x * std::sin(yaw) + y * std::cos(yaw), z + kBelow};
}

/// The triangles that face an eye at the origin: two for each side beyond whose plane it lies.
int facing_in_double(const RowInput& input) {
    const double yaw = static_cast<double>(input.values[1]) * std::numbers::pi / 180;
    const double x = -kAhead, y = -static_cast<double>(input.values[2]) / 4;
    const double own_x = x * std::cos(yaw) + y * std::sin(yaw), own_y = y * std::cos(yaw) - x * std::sin(yaw);
    return 2 * ((std::abs(own_x) > 1) + (std::abs(own_y) > 1) + (std::abs(kBelow) > 1));
}

RowPage draw_stages(const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    fill_area(canvas, {0, 0, canvas.width_px, canvas.height_px}, assets.colour(18, 22, 34));
    const auto stage = static_cast<Stage>(input.values[0]);
    const Area area = scene_area(canvas, 188);
    const Framebuffer part = part_of(canvas, area);
    const StagedCube cube(input, part);
    if (stage <= Stage::View)
        draw_from_outside(cube, stage, input, canvas, area);
    else
        draw_from_eye(cube, stage, input, part);
    std::vector<std::string> lines{caption_of(stage)};
    for (std::string& line : numbers_of(cube, stage)) lines.push_back(std::move(line));
    const auto most = static_cast<std::size_t>(area.height / kLineHeight_px);
    if (lines.size() > most) lines.resize(most);
    draw_column(canvas, canvas.width_px * 190 / 320, kHeader_px + 3, lines, assets.text);

    const auto world = world_in_double(input, 0);
    const ViewVertex& vertex = cube.scratch.view_vertices[0];
    std::int64_t span_pixels = 0;
    for (const ShownTriangle& triangle : cube.triangles)
        for (const Span& span : triangle.spans) span_pixels += span.end - span.first;
    return {
        {count_figure("triangles that face the eye", facing_in_double(input), std::ssize(cube.triangles)),
         number_figure("vertex 0 in the world: y", world[1], number_of(cube.scratch.world_vertices[0].position.y),
                       1e-3),
         number_figure("vertex 0 in view space: x = -y of the world", -world[1], number_of(vertex.position.x), 2e-3),
         number_figure("vertex 0 in view space: z = x of the world", world[0], number_of(vertex.position.z), 2e-3),
         measured("pixels of all spans", std::to_string(span_pixels))},
        {"The functions that draw models, in their order: engine/mesh/mesh_stages.h.",
         "Outcodes: L left, R right, B bottom, T top, Z behind. A convex shape covers no pixel twice."}};
}

}  // namespace

std::vector<Row> stage_rows() {
    return {{"pipeline",
             "Step through the pipeline",
             "3 Notes: 3D Pipeline; 4 Princeton: pipeline; 5 Abrash: spaces",
             "engine/mesh/mesh_stages.h",
             "tests/gallery/stages_test.cpp",
             {choice_parameter("stage", kStageNames, 2),
              {"yaw, degrees", 0, 85, 5, 25},
              {"to the left, quarters of a unit", -10, 10, 1, 9}},
             draw_stages}};
}

}  // namespace oblong
