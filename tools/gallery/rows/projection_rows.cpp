// Seeds 2 and 4: parallel projections, the vanishing points of the perspective one, an OpenGL polygon in the pipeline.

#include "engine/frame/frame_counts.h"
#include "engine/methods/lines.h"
#include "engine/methods/transforms.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

constexpr Cube kCube{{-50, -50, -50}, 100};
constexpr double kCubeWidth = 340;  ///< units across the screen
constexpr View kViewWidth = View::from_int(340);

/// The cube in the middle between header and footer.
void draw_cube_scene(const RowInput& input, const ViewSpec& view, const Canvas& canvas) {
    const double unit_px = input.mode.width_px / kCubeWidth * number_of(input.mode.pixel());
    ViewSpec moved = view;
    moved.eye = world_point(vec_of(view.axes.up) * -((kFooter_px - kHeader_px) / 2.0 / unit_px));
    WireScene scene(canvas, moved);
    scene.cube(kCube);
    scene.axes(kCube.low, 145);
}

/// The lengths of the cube's edges along x, y and z in the picture, as factors of their true length.
Vec edge_factors(const RowInput& input, const ViewSpec& view) {
    const ViewContext context = make_view_context(view, input.mode);
    Vec factors;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec way = shown(kCube.corner(1 << axis), context) - shown(kCube.low, context);
        factors[axis] = std::hypot(way.x, way.y * number_of(input.mode.pixel().inverse())) /
                        (100 * input.mode.width_px / kCubeWidth);
    }
    return factors;
}

/// A parallel view of the cube, with these factors expected.
Figures draw_parallel(const RowInput& input, const ViewSpec& view, const Vec& factors, const Canvas& canvas) {
    draw_cube_scene(input, view, canvas);
    const Vec found = edge_factors(input, view);
    return {{"edge along x / its true length", factors.x, found.x, 0.001},
            {"along y", factors.y, found.y, 0.001},
            {"along z", factors.z, found.z, 0.001}};
}

Figures draw_orthographic(const RowInput& input, Canvas& canvas) {
    constexpr std::array<Vec, 3> kFactors{{{1, 0, 1}, {1, 1, 0}, {0, 1, 1}}};
    const auto side = static_cast<ViewSide>(input.values[0]);
    return draw_parallel(input, orthographic_view({}, side_axes(side), kViewWidth), item(kFactors, side), canvas);
}

Figures draw_axonometric(const RowInput& input, Canvas& canvas) {
    const auto kind = static_cast<Axonometry>(input.values[0]);
    const Angle turn = degrees_to_angle(Degrees::from_int(90 * input.values[1]));
    const ViewSpec view = orthographic_view({}, axonometric_axes(kind, turn), kViewWidth);
    // An axis is shortened to sqrt(1 - c^2), with c its component along the rays.
    const double equal = std::sqrt(2 / 3.0), root2 = std::sqrt(2);
    const std::array<Vec, 3> factors{{{equal, equal, equal},
                                      {root2 / 3, 2 * root2 / 3, 2 * root2 / 3},
                                      {std::sqrt(25 / 50.0), std::sqrt(34 / 50.0), std::sqrt(41 / 50.0)}}};
    Vec here = item(factors, kind);
    if (input.values[1] % 2 == 1) std::swap(here.x, here.y);
    Figures figures = draw_parallel(input, view, here, canvas);
    const Vec factor = edge_factors(input, view);
    std::array found{factor.x, factor.y, factor.z};
    std::sort(found.begin(), found.end());
    const int different = 1 + (found[1] - found[0] > 0.02) + (found[2] - found[1] > 0.02);
    figures.insert(figures.begin(), {"different factors: iso 1, di 2, tri 3", input.values[0] + 1, different});
    return figures;
}

Figures draw_oblique(const RowInput& input, Canvas& canvas) {
    const double length = input.values[0] == 0 ? 1 : 0.5;
    const ViewSpec view =
        oblique_view({}, side_axes(ViewSide::Front), kViewWidth, fixed_of<Unit>(length), input.angle(1));
    Figures figures = draw_parallel(input, view, {1, length, 1}, canvas);
    const ViewContext context = make_view_context(view, input.mode);
    figures.push_back({"right per unit of depth, L cos a", length * std::cos(input.radians(1)),
                       across(kCube.low, kCube.corner(2), context) / across(kCube.low, kCube.corner(1), context),
                       0.001});
    return figures;
}

/// Views of the demo level from outside.
ViewSpec level_view(std::int64_t choice) {
    constexpr View kWidth = View::from_int(2300);
    if (choice < 3)
        return orthographic_view(middle_of_demo_level(), axonometric_axes(static_cast<Axonometry>(choice)), kWidth);
    // From above, with heights drawn to the upper right.
    return oblique_view(middle_of_demo_level(), side_axes(ViewSide::Top), kWidth,
                        Unit::from_raw(choice == 3 ? 1 << 30 : 1 << 29), Angle{0xa000});
}

Figures draw_level_from_outside(const RowInput& input, Canvas& canvas) {
    ViewSpec view = level_view(input.values[0]);
    cut_above(view, World::from_int(static_cast<std::int32_t>(input.values[1])));
    DemoFrame frame(input, input.mode);
    FrameCounts counts;
    frame.work.observers.counts = &counts;
    frame.draw(view, canvas);
    std::int64_t twice = 0, never = 0;
    for (const std::uint8_t writes : counts.writes) {
        twice += writes > 1;
        never += writes == 0;
    }
    return {{"pixels that faces draw twice", 0, twice},
            {"pixels that show nothing", never},
            {"faces that own pixels", counts.faces_drawn}};
}

/// A camera whose picture of the cube has this number of vanishing points.
Camera camera_with_points(int points) {
    if (points == 1) return camera_at(110, -310, 100, 90, 0, 100);
    if (points == 2) return camera_at(-160, -160, 15, 45, 0, 100);
    return camera_at(-140, -140, 150, 45, 38, 100);
}

/// The vanishing point of an axis: the projection of its direction, x m / z; none for directions parallel to the view
/// plane.
std::optional<Vec> vanishing_point(const Vec& axis, const ViewContext& view) {
    const double z = dot(axis, vec_of(view.axes.forward));
    if (std::abs(z) < 1e-6) return std::nullopt;
    const Projection& to = view.projection;
    return Vec{to.width_px / 2.0 + number_of(to.x.multiplier) * dot(axis, vec_of(view.axes.right)) / z,
               to.height_px / 2.0 - number_of(to.y.multiplier) * dot(axis, vec_of(view.axes.up)) / z};
}

Figures draw_vanishing_points(const RowInput& input, Canvas& canvas) {
    const auto points = static_cast<int>(input.values[0]) + 1;
    const Camera camera = camera_with_points(points);
    WireScene scene(canvas, first_person_view(camera));
    constexpr std::array<Vec, 3> kAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    constexpr std::array<Rgb8, 3> kColours{{{150, 60, 56}, {66, 120, 60}, {60, 90, 150}}};
    int found = 0;
    double worst_px = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::optional<Vec> point = vanishing_point(kAxes[axis], scene.view());
        if (!point) continue;
        ++found;
        for (int corner = 0; corner < 8; ++corner)
            canvas.line(scene.pixel_of(kCube.corner(corner)), *point, kColours[axis]);
        // Compared with the engine's projection of a point 2^18 units ahead of the eye.
        const double way = dot(kAxes[axis], vec_of(scene.view().axes.forward)) > 0 ? 262144 : -262144;
        const Vec off = scene.pixel_of(vec_of(camera.eye) + kAxes[axis] * way) - *point;
        worst_px = std::max(worst_px, std::hypot(off.x, off.y));
    }
    scene.cube(kCube);
    return {{"axes that have a vanishing point", points, found},
            {"pixels to what is 2^18 units along", 0, worst_px, 0.02}};
}

constexpr std::array<Vec, 4> kQuad{{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 1}}};
constexpr Vec kQuadTarget{0.5, 0.5, 0.5};
constexpr int kQuadView = 32;

/// OpenGL's axes, x right, y up, z toward the viewer, in the engine's: x east, y north, z up.
Vec from_gl(const Vec& p) {
    return {p.x, -p.z, p.y};
}

/// A point's position in a part of the picture, in doubles.
Vec pixel_in_double(const Vec& p, const Vec& eye, const RowInput& input, const Area& area) {
    const Vec forward = normalised(kQuadTarget - eye), right = normalised(cross(forward, {0, 1, 0})),
              up = cross(right, forward), way = p - eye;
    const double d = area.width / 2.0 / std::tan(kQuadView * std::numbers::pi / 360);
    return {area.width / 2.0 + d * dot(way, right) / dot(way, forward),
            area.height / 2.0 - d * number_of(input.mode.pixel()) * dot(way, up) / dot(way, forward)};
}

Figures draw_opengl_quad(const RowInput& input, Canvas& canvas) {
    const double turn = input.radians(0);
    const Vec eye{0.5 + 4 * std::sin(turn), 1.6, 0.5 + 4 * std::cos(turn)};
    const Area area = canvas.scene(180);
    Sketch sketch(canvas, area, {from_gl(eye), from_gl(kQuadTarget), kQuadView});
    std::array<Vec, 4> corners;
    std::transform(kQuad.begin(), kQuad.end(), corners.begin(), from_gl);
    sketch.polygon(corners, kAmber);
    std::int64_t pixels = 0;
    for (std::int32_t y = 0; y < sketch.height_px; ++y)
        pixels += std::count(sketch.row(y), sketch.row(y) + sketch.width_px, input.colour(kAmber));
    sketch.outline(corners, kGold);
    sketch.axes({from_gl({1.3, 0, 0}), from_gl({0, 1.3, 0}), from_gl({0, 0, 1.3})});
    double worst_px = 0, shoelace = 0;
    std::vector<std::string> lines{"glBegin(GL_POLYGON)"};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec expected = pixel_in_double(kQuad[i], eye, input, area),
                  next = pixel_in_double(kQuad[(i + 1) % 4], eye, input, area), found = sketch.pixel_of(corners[i]);
        worst_px = std::max(worst_px, std::hypot(found.x - expected.x, found.y - expected.y));
        shoelace += cross(expected, next).z / 2;
        lines.push_back("glVertex3f(" + triple_text(kQuad[i], "%.0f", ", ") + ")");
        const Vec3<Entry> divided = *point_of(sketch.world_to_volume() * homogeneous(world_point(corners[i])));
        lines.push_back(decimals_text({divided.x, divided.y}, "%6.3f") + decimal_text(divided.z, " %6.4f"));
        lines.push_back("  " + decimal_text(found.x, "%7.2f") + decimal_text(found.y, "%8.2f"));
    }
    lines.push_back("glEnd()");
    canvas.column(canvas.width_px * 186 / 320, 8, lines);

    std::array<Vec3<World>, 4> quad;
    std::transform(corners.begin(), corners.end(), quad.begin(), [](const Vec& p) { return world_point(p); });
    const Plane plane = plane_through(quad[0], normalised(cross(quad[1] - quad[0], quad[3] - quad[0])));
    return {
        {"area of the polygon: root 2", std::numbers::sqrt2,  // by its diagonals
         length(vec_of(cross(quad[2] - quad[0], quad[3] - quad[1]))) / 2, 1e-9, 6},
        {"its fourth corner's distance from the others' plane", 0, distance_to_plane(quad[2], plane), 1e-6, 6},
        {"pixels from the closed form: worst corner", 0, worst_px,
         0.01 * std::max({1.0, area.width / 180.0, area.height / 154.0})},
        {"pixels drawn: the area of its picture", std::abs(shoelace), pixels, (area.width + area.height) / 16.0, 0}};
}

}  // namespace

std::vector<Row> projection_rows() {
    return {{"orthographic", draw_orthographic, {{"view", {"front", "top", "side"}}}},
            {"axonometric",
             draw_axonometric,
             {{"view", {"isometric", "dimetric", "trimetric"}}, {"quarters turned", 0, 3, 1, 0}}},
            {"oblique", draw_oblique, {{"view", {"cavalier", "cabinet"}}, {"angle", 0, 90, 15, 45}}},
            {"level-from-outside",
             draw_level_from_outside,
             {{"view", {"isometric", "dimetric", "trimetric", "cavalier plan", "cabinet plan"}},
              {"cut off above", 0, 640, 80, 80}}},
            {"vanishing-points", draw_vanishing_points, {{"vanishing points", {"one", "two", "three"}, 1}}},
            {"opengl-quad", draw_opengl_quad, {{"seen from, degrees", -60, 60, 10, 30}}}};
}

}  // namespace oblong
