// Seeds 2 and 4: parallel projections, and the vanishing points of the perspective one.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/fixed/trig.h"
#include "engine/frame/frame_counts.h"
#include "engine/view/views.h"
#include "tools/gallery/row.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

/// The length of a line on the display, in columns.
double length_on_display(const Vec& from, const Vec& to, const ViewContext& view, const ScreenMode& mode) {
    const PlanePoint a = shown(from, view), b = shown(to, view);
    return std::hypot(b.x - a.x, (b.y - a.y) * number_of(mode.pixel().inverse()));
}

constexpr Cube kCube{{-50, -50, -50}, 100};
constexpr double kCubeWidth = 340;  ///< units across the screen

/// The cube in the middle between header and footer.
void draw_cube_scene(const RowInput& input, const ViewSpec& view, Framebuffer canvas) {
    const double unit_px = input.mode.width_px / kCubeWidth * number_of(input.mode.pixel());
    const double down = (kFooter_px - kHeader_px) / 2.0 / unit_px;
    ViewSpec moved = view;
    moved.eye = world_point(vec_of(view.axes.up) * -down);
    WireScene scene(input, moved, canvas);
    scene.fill_background();
    draw_cube(kCube, input.assets, scene);
    draw_axes(kCube.low, 145, input.assets, scene);
}

ViewContext context_of(const RowInput& input, const ViewSpec& view) {
    return make_view_context(view, input.mode);
}

const Vec kX{50, -50, -50}, kY{-50, 50, -50}, kZ{-50, -50, 50};

/// The lengths of the cube's edges along x, y and z in the picture; expected: factors of their true length.
std::vector<Figure> edge_figures(const RowInput& input, const ViewSpec& view, const std::array<double, 3>& factors) {
    const ViewContext context = context_of(input, view);
    const double true_length = 100 * input.mode.width_px / kCubeWidth;
    const std::array<const Vec*, 3> ends{&kX, &kY, &kZ};
    constexpr std::array<const char*, 3> kNames{"edge along x / its true length", "along y", "along z"};
    std::vector<Figure> figures;
    for (std::size_t axis = 0; axis < 3; ++axis)
        figures.push_back(number_figure(kNames[axis], factors[axis],
                                        length_on_display(kCube.low, *ends[axis], context, input.mode) / true_length,
                                        0.001));
    return figures;
}

Figures draw_orthographic(const RowInput& input, Framebuffer canvas) {
    const auto side = static_cast<ViewSide>(input.values[0]);
    const ViewSpec view = orthographic_view({}, side_axes(side), View::from_int(static_cast<std::int64_t>(kCubeWidth)));
    draw_cube_scene(input, view, canvas);
    constexpr std::array<std::array<double, 3>, 3> kFactors{{{1, 0, 1}, {1, 1, 0}, {0, 1, 1}}};
    return edge_figures(input, view, item(kFactors, static_cast<std::int32_t>(input.values[0])));
}

Figures draw_axonometric(const RowInput& input, Framebuffer canvas) {
    const auto kind = static_cast<Axonometry>(input.values[0]);
    const Angle turn = degrees_to_angle(Degrees::from_int(90 * input.values[1]));
    const ViewSpec view =
        orthographic_view({}, axonometric_axes(kind, turn), View::from_int(static_cast<std::int64_t>(kCubeWidth)));
    draw_cube_scene(input, view, canvas);
    // An axis is shortened to sqrt(1 - c^2), with c its component along the rays.
    const double equal = std::sqrt(2 / 3.0), root2 = std::sqrt(2);
    const std::array<std::array<double, 3>, 3> factors{
        {{equal, equal, equal},
         {root2 / 3, 2 * root2 / 3, 2 * root2 / 3},
         {std::sqrt(25 / 50.0), std::sqrt(34 / 50.0), std::sqrt(41 / 50.0)}}};
    std::array<double, 3> here = item(factors, static_cast<std::int32_t>(input.values[0]));
    if (input.values[1] % 2 == 1) std::swap(here[0], here[1]);
    std::vector<Figure> figures = edge_figures(input, view, here);
    std::array<double, 3> found{};
    for (std::size_t axis = 0; axis < 3; ++axis) found[axis] = std::stod(figures[axis].found);
    std::sort(found.begin(), found.end());
    const int different = 1 + (found[1] - found[0] > 0.02) + (found[2] - found[1] > 0.02);
    figures.push_back(count_figure("different factors: iso 1, di 2, tri 3", input.values[0] + 1, different));
    std::rotate(figures.begin(), figures.end() - 1, figures.end());
    return figures;
}

ViewSpec oblique_cube_view(double length, std::int64_t degrees) {
    return oblique_view({}, side_axes(ViewSide::Front), View::from_int(static_cast<std::int64_t>(kCubeWidth)),
                        fixed_of<Unit>(length), degrees_to_angle(Degrees::from_int(degrees)));
}

Figures draw_oblique(const RowInput& input, Framebuffer canvas) {
    const double length = input.values[0] == 0 ? 1 : 0.5, degrees = input.number(1);
    const ViewSpec view = oblique_cube_view(length, input.values[1]);
    draw_cube_scene(input, view, canvas);
    std::vector<Figure> figures = edge_figures(input, view, {1, length, 1});
    const ViewContext context = context_of(input, view);
    figures.push_back(number_figure("right per unit of depth, L cos a",
                                    length * std::cos(degrees * std::numbers::pi / 180),
                                    across(kCube.low, kY, context) / across(kCube.low, kX, context), 0.001));
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

Figures draw_level_from_outside(const RowInput& input, Framebuffer canvas) {
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
    return {count_figure("pixels that faces draw twice", 0, twice), measured("pixels that show nothing", never),
            measured("faces that own pixels", counts.faces_drawn)};
}

/// A camera whose picture of the cube has this number of vanishing points.
Camera camera_with_points(int points) {
    constexpr std::array<Vec, 3> kEyes{{{110, -310, 100}, {-160, -160, 15}, {-140, -140, 150}}};
    Camera camera;
    camera.eye = world_point(item(kEyes, points - 1));
    camera.yaw = degrees_to_angle(Degrees::from_int(points == 1 ? 90 : 45));
    camera.pitch = degrees_to_angle(Degrees::from_int(points == 3 ? 38 : 0));
    camera.field_of_view = Degrees::from_int(100);
    return camera;
}

/// The vanishing point of an axis: the projection of its direction, x m / z; none for directions parallel to the view
/// plane.
std::optional<PlanePoint> vanishing_point(const Vec3<Unit>& axis, const ViewContext& view) {
    const auto part = [&](const Vec3<Unit>& of_view) { return number_of(dot(axis, of_view)); };
    const double z = part(view.axes.forward);
    if (std::abs(z) < 1e-6) return std::nullopt;
    return PlanePoint{
        view.projection.width_px / 2.0 + number_of(view.projection.x.multiplier) * part(view.axes.right) / z,
        view.projection.height_px / 2.0 - number_of(view.projection.y.multiplier) * part(view.axes.up) / z};
}

Figures draw_vanishing_points(const RowInput& input, Framebuffer canvas) {
    const auto points = static_cast<int>(input.values[0]) + 1;
    const Camera camera = camera_with_points(points);
    WireScene scene(input, first_person_view(camera), canvas);
    scene.fill_background();
    constexpr Unit kOne = Unit::from_int(1);
    const std::array<Vec3<Unit>, 3> axes{{{kOne, {}, {}}, {{}, kOne, {}}, {{}, {}, kOne}}};
    const std::array<std::uint8_t, 3> colours{input.assets.colour(150, 60, 56), input.assets.colour(66, 120, 60),
                                              input.assets.colour(60, 90, 150)};
    int found = 0;
    double worst_px = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::optional<PlanePoint> point = vanishing_point(axes[axis], scene.view());
        if (!point) continue;
        ++found;
        for (int corner = 0; corner < 8; ++corner)
            scene.line(shown(kCube.corner(corner), scene.view()), *point, colours[axis]);
        // Compared with the engine's projection of a point 2^18 units ahead of the eye.
        Vec far = vec_of(camera.eye);
        const double way = dot(axes[axis], scene.view().axes.forward) > Sine60{} ? 262144 : -262144;
        far[axis] += way;
        const PlanePoint seen = shown(far, scene.view());
        worst_px = std::max(worst_px, std::hypot(seen.x - point->x, seen.y - point->y));
    }
    draw_cube(kCube, input.assets, scene);
    return {count_figure("axes that have a vanishing point", points, found),
            number_figure("pixels to what is 2^18 units along", 0, worst_px, 0.02)};
}

}  // namespace

std::vector<Row> projection_rows() {
    return {{"orthographic", draw_orthographic, {choice_parameter("view", {"front", "top", "side"})}},
            {"axonometric",
             draw_axonometric,
             {choice_parameter("view", {"isometric", "dimetric", "trimetric"}), {"quarters turned", 0, 3, 1, 0}}},
            {"oblique", draw_oblique, {choice_parameter("view", {"cavalier", "cabinet"}), {"angle", 0, 90, 15, 45}}},
            {"level-from-outside",
             draw_level_from_outside,
             {choice_parameter("view", {"isometric", "dimetric", "trimetric", "cavalier plan", "cabinet plan"}),
              {"cut off above", 0, 640, 80, 80}}},
            {"vanishing-points",
             draw_vanishing_points,
             {choice_parameter("vanishing points", {"one", "two", "three"}, 1)}}};
}

}  // namespace oblong
