// The pipeline, stopped after each stage: a cube by the functions that draw models, with the numbers after each stage.

#include "engine/methods/polygons.h"
#include "engine/methods/transforms.h"
#include "tools/gallery/sketch.h"
#include "tools/gallery/staged_cube.h"

namespace oblong {

namespace {

/// The eye looks east, and down with slope 1/2: forward is (kLevel, 0, -kDown), up is (kDown, 0, kLevel).
const double kLevel = 2 / std::sqrt(5.0), kDown = 1 / std::sqrt(5.0);

/// The world point with these viewspace coordinates.
DrawnPoint point_before_eye(double right, double up, double ahead) {
    return {ahead * kLevel + up * kDown, -right, up * kLevel - ahead * kDown};
}

/// The triangles that face the eye, lit or in plain colours: from `from`, back ones first.
void draw_sides(const StagedCube& cube, Stage stage, std::span<const Vec3<World>> places, const Vec& from,
                Sketch& sketch) {
    for (const bool is_front : {false, true})
        for (const ShownTriangle& shown : cube.triangles) {
            std::array<Vec3<World>, 3> corners;
            for (std::size_t i = 0; i < 3; ++i)
                corners[i] = item(places, cube.mesh.triangles[shown.number].vertices[i]);
            const Vec3<Unit> normal = normalised(cross(corners[2] - corners[0], corners[1] - corners[0]));
            if (faces_away(corners[0], normal, world_point(from)) == is_front) continue;
            const auto lit = [&](int full) {
                return static_cast<std::uint8_t>(full * std::min(shown.light / 150, 1.0));
            };
            sketch.polygon(corners, stage == Stage::Lit ? Rgb8{lit(230), lit(160), lit(70)} : is_front ? kGrey : kDusk);
        }
}

/// The eye at the origin, and its view up to a depth of 7.
void draw_view(Sketch& sketch) {
    const double across = 7 * std::tan(30 * kDegree),
                 up = across * sketch.height_px / sketch.width_px * number_of(sketch.input.mode.pixel().inverse());
    const std::array far{point_before_eye(-across, up, 7), point_before_eye(across, up, 7),
                         point_before_eye(across, -up, 7), point_before_eye(-across, -up, 7)};
    sketch.outline(far, kDim);
    for (const DrawnPoint& corner : far) sketch.line({0, 0}, corner, kDim);
    sketch.label({0, 0}, "eye", kWhite);
}

/// The cube in its own space, or in the world with the eye and its view, from outside.
void draw_from_outside(const StagedCube& cube, Stage stage, const Canvas& canvas, const Area& area) {
    const bool is_object = stage <= Stage::Facing, shows_sides = stage == Stage::Facing || stage == Stage::Lit;
    const SketchEye from = stage == Stage::Object   ? SketchEye{{5, -6, 4}, {0, 0, 0}, 40}
                           : stage == Stage::Facing ? SketchEye{{1, -10, 7}, {-1, -1, 0.8}, 42}
                           : stage == Stage::Lit    ? SketchEye{{1, -5, 1.5}, {3.8, 1.2, -1}, 46}
                                                    : SketchEye{{-5, -9, 4}, {2.6, 0, -1.5}, 46};
    Sketch sketch(canvas, area, from);
    std::vector<Vec3<World>> places;
    for (std::uint32_t i = 0; i < 8; ++i)
        places.push_back(is_object ? cube.mesh.frames[0].vertices[i].position
                                   : cube.scratch.world_vertices[i].position);
    if (shows_sides) draw_sides(cube, stage, places, from.eye, sketch);
    if (stage == Stage::InView)  // x is right, y up, z ahead
        sketch.axes({point_before_eye(2.2, 0, 0), point_before_eye(0, 2.2, 0), point_before_eye(0, 0, 2.2)});
    else
        sketch.axes({{{2.2, 0, 0}, {0, 2.2, 0}, {0, 0, 2.2}}});
    if (stage == Stage::Facing) {
        sketch.line(cube.object_eye, {0, 0}, kDim);
        sketch.label(cube.object_eye, "eye", kWhite);
    }
    if (stage == Stage::Lit) {
        const Vec3<World> top = cube.placed.position + world_point(0, 0, 1);
        const Vec3<World> lamp = top + world_point(vec_of(cube.light.directional.toward) * 2);
        sketch.line(top, lamp, kLemon);
        sketch.label(lamp, "to the light", kLemon);
    }
    if (!is_object) draw_view(sketch);
    draw_edges(
        sketch, [&](int i) { return item(places, i); }, kOrange);
    for (std::size_t i = 0; i < 8 && !shows_sides; ++i) sketch.label(places[i], std::to_string(i), kWhite);
}

/// The cube seen from the eye: outlines of the clipped triangles, spans, pixels.
void draw_from_eye(const StagedCube& cube, Stage stage, Canvas part) {
    if (stage == Stage::Pixels) {
        DepthBuffer depth(part.width_px, part.height_px);
        const ScreenRectangle all{0, part.width_px, 0, part.height_px};
        depth.start_frame();
        depth.want(all);
        depth.clear();
        MeshScratch scratch(part.height_px);
        draw_mesh(cube.placed, {cube.view, part.input.assets.colormap, cube.light}, {depth, part, all}, scratch);
        return;
    }
    for (const ShownTriangle& triangle : cube.triangles) {
        for (const Span& span : triangle.spans) {
            // Every second one is left out, so that spans can be told apart.
            if (stage == Stage::Spans && span.y % 2 != 0)
                part.box({span.first, span.y, span.end - span.first, 1},
                         triangle.number % 2 == 0 ? kBlue : Rgb8{70, 105, 180});
            if (stage != Stage::Scanned) continue;
            part.box({span.first, span.y, 1, 1}, kGreen);
            part.box({span.end - 1, span.y, 1, 1}, kRed);
        }
        if (stage > Stage::Projected) continue;
        std::vector<Vec> corners;
        for (const ScreenCorner& corner : triangle.corners)
            corners.push_back({number_of(corner.screen.x), number_of(corner.screen.y)});
        for (std::size_t i = 0; i < corners.size(); ++i) {
            part.line(corners[i], corners[(i + 1) % corners.size()], kOrange);
            if (stage == Stage::Projected) part.dot(corners[i], kGreen);
        }
    }
}

/// The canonical volume from its front, -1 to 1 across and up, whatever the screen's shape: the clipped triangles after
/// the perspective divide.
void draw_divided(const StagedCube& cube, const Canvas& canvas, const Area& area) {
    Diagram diagram(canvas.part({0, 0, area.width, canvas.height_px}), {0, 0}, 2.5);
    diagram.line({-1.2, 0}, {1.2, 0}, kDim);
    diagram.line({0, -1.2}, {0, 1.2}, kDim);
    diagram.outline(box_of({-1, -1}, {1, 1}), kBlue);
    diagram.label({-1, -1}, "-1", kBlue, -14, 0);
    diagram.label({1, 1}, "1", kBlue);
    for (const ShownTriangle& triangle : cube.triangles)
        for (std::size_t i = 0; i < triangle.divided.size(); ++i) {
            diagram.line(triangle.divided[i], triangle.divided[(i + 1) % triangle.divided.size()], kOrange);
            diagram.disc(vec_of(triangle.divided[i]), 0.03, kGreen);
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

/// The cube by sines and cosines in double.
struct CubeInDouble {
    double cos, sin, left;

    explicit CubeInDouble(const RowInput& input)
        : cos(std::cos(input.radians(1))), sin(std::sin(input.radians(1))), left(input.number(2) / 4) {}

    /// Its first vertex in the world.
    Vec first_vertex() const { return {kCubeAhead - cos + sin, left - sin - cos, kCubeBelow - 1}; }
    /// The eye, which is at the origin, along the cube's own axes.
    double own_x() const { return -kCubeAhead * cos - left * sin; }
    double own_y() const { return -left * cos + kCubeAhead * sin; }
    /// The triangles that face the eye: two for each side whose plane is between it and the cube.
    int facing() const { return 2 * ((std::abs(own_x()) > 1) + (std::abs(own_y()) > 1) + (std::abs(kCubeBelow) > 1)); }
    /// The light of those triangles: 40 plus 110 times the cosine between a side's normal and (-2, -1, 2), of length 3.
    double light() const {
        const auto side = [](const Vec& normal) { return 40 + 110 * std::max(dot(normal, Vec{-2, -1, 2}) / 3, 0.0); };
        const double east = std::copysign(1, own_x()), north = std::copysign(1, own_y());
        return 2 * (side({0, 0, 1}) +  // the eye is above the cube
                    (std::abs(own_x()) > 1 ? side({east * cos, east * sin}) : 0) +
                    (std::abs(own_y()) > 1 ? side({-north * sin, north * cos}) : 0));
    }
};

Figures draw_stages(const RowInput& input, Canvas& canvas) {
    const auto stage = static_cast<Stage>(input.values[0]);
    const Area area = canvas.scene(188);
    const Canvas part = canvas.part(area);
    const StagedCube cube(input, part);
    if (stage <= Stage::InView)
        draw_from_outside(cube, stage, canvas, area);
    else if (stage == Stage::Divided)
        draw_divided(cube, canvas, area);
    else
        draw_from_eye(cube, stage, part);
    canvas.column(canvas.width_px * 190 / 320, 3, cube.lines_of(stage));

    std::int64_t span_pixels = 0;
    double light = 0;
    for (const ShownTriangle& triangle : cube.triangles) {
        light += triangle.light;
        for (const Span& span : triangle.spans) span_pixels += span.end - span.first;
    }
    const CubeInDouble expected(input);
    const Vec world = expected.first_vertex();
    const Vec3<World>& first = cube.scratch.world_vertices[0].position;
    const Vec3<View>& in_view = cube.scratch.view_vertices[0].position;
    const Vec3<Entry> divided = *point_of(cube.to_volume() * homogeneous(first));
    const double ahead = world.x * kLevel - world.z * kDown;
    // Both round in view space: 1/100 pixel in 320x200, and in proportion in larger pictures.
    const double rounding_px = 0.01 * std::max({1.0, part.width_px / 188.0, part.height_px / 154.0});
    return {{"triangles that face the eye", expected.facing(), std::ssize(cube.triangles)},
            {"vertex 0 in the world: y", world.y, first.y, 1e-3},
            {"vertex 0 in view space: x, to the right", -world.y, in_view.x, 2e-3},
            {"vertex 0 in view space: y, up", world.x * kDown + world.z * kLevel, in_view.y, 2e-3},
            {"vertex 0 in view space: z, ahead", ahead, in_view.z, 2e-3},
            {"light of all that face it, by cosines", expected.light(), light, 0.1, 1},
            {"vertex 0 divided: x / (z tan 30)", -world.y / (ahead * std::tan(30 * kDegree)), divided.x, 1e-3},
            {"its depth: f / (f - n) (1 - n / z)", kVolumeFar / (kVolumeFar - kVolumeNear) * (1 - kVolumeNear / ahead),
             divided.z, 1e-4},
            {"pixels from there to the screen's corners", 0, viewport_error_px(cube, part), rounding_px},
            {"pixels of all spans", span_pixels}};
}

}  // namespace

std::vector<Row> stage_rows() {
    return {
        {"pipeline",
         draw_stages,
         {{"stage", kStageNames}, {"yaw, degrees", 0, 85, 5, 60}, {"to the left, quarters of a unit", -10, 10, 1, 7}}}};
}

}  // namespace oblong
