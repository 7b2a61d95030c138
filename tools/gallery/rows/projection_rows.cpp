// Seeds 2 and 4: parallel projections, and the vanishing points of the perspective one.

#include "engine/frame/frame_counts.h"
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
            {"vanishing-points", draw_vanishing_points, {{"vanishing points", {"one", "two", "three"}, 1}}}};
}

}  // namespace oblong
