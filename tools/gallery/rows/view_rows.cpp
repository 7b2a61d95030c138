// Seeds 2, 3 and 4: cameras, windows and projections.

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "engine/fixed/trig.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/geometry/project.h"
#include "engine/geometry/screen_polygon.h"
#include "engine/geometry/views.h"
#include "engine/raster/lines.h"
#include "engine/raster/scan.h"
#include "tools/common/drawing.h"
#include "tools/gallery/level_scene.h"
#include "tools/gallery/numbers.h"
#include "tools/gallery/rows.h"

namespace oblong {

namespace {

struct Place {
    double x = 0, y = 0, z = 0;
};

Vec3<World> in_world(const Place& place) {
    const auto part = [](double value) {
        return World::from_raw(static_cast<std::int32_t>(std::lround(value * 4096)));
    };
    return {part(place.x), part(place.y), part(place.z)};
}

struct PixelPlace {
    double x, y;
};

/// Where the engine shows a place, pixels.
PixelPlace shown(const Place& place, const ViewContext& view) {
    const ScreenPosition position = project(to_view(in_world(place), view), view.projection);
    return {std::ldexp(position.x.raw, -8), std::ldexp(position.y.raw, -8)};
}

double across(const Place& from, const Place& to, const ViewContext& view) {
    return std::abs(shown(to, view).x - shown(from, view).x);
}

/// How long a line is on the display, in columns.
double length_on_display(const Place& from, const Place& to, const ViewContext& view, const ScreenMode& mode) {
    const PixelPlace a = shown(from, view), b = shown(to, view);
    const Ratio pixel = mode.pixel();
    const double shape = static_cast<double>(pixel.denominator) / static_cast<double>(pixel.numerator);
    return std::hypot(b.x - a.x, (b.y - a.y) * shape);
}

std::string text_of(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// Draws lines of the world as the engine projects them.
class WireScene {
  public:
    WireScene(const RowInput& input, const ViewSpec& spec, Framebuffer canvas)
        : assets_(input.assets),
          canvas_(canvas),
          rows_(canvas.height_px),
          view_(make_view_context(spec, input.mode, {30, View::kFractionBits, 8, input.settings.correct_aspect})) {}

    const ViewContext& view() const { return view_; }

    void fill_background() {
        fill_area(canvas_, {0, 0, canvas_.width_px, canvas_.height_px}, assets_.colour(20, 24, 36));
    }
    void line(const Place& from, const Place& to, std::uint8_t colour) {
        const PixelPlace a = shown(from, view_), b = shown(to, view_);
        line(a, b, colour);
    }
    void line(const PixelPlace& from, const PixelPlace& to, std::uint8_t colour) {
        const auto pixel = [](const PixelPlace& at) {
            return PixelPosition{static_cast<std::int32_t>(std::floor(at.x)),
                                 static_cast<std::int32_t>(std::floor(at.y))};
        };
        draw_line(pixel(from), pixel(to), {LineMethod::Bresenham, colour}, canvas_);
    }
    /// A polygon seen from its front, clockwise: all of it, or nothing from behind.
    bool polygon(std::span<const Place> corners, std::uint8_t colour) {
        std::vector<Vec3<World>> world;
        for (const Place& corner : corners) world.push_back(in_world(corner));
        if (!project_polygon(world, view_, polygon_) || doubled_area(polygon_.screen) <= ScreenArea{}) return false;
        scan_convex(polygon_.screen, rows_);
        for (std::int32_t y = rows_.first; y < rows_.end; ++y)
            for (std::int32_t x = std::max(at(rows_.left, y), 0); x < at(rows_.right, y); ++x)
                set_pixel(canvas_, x, y, colour);
        return true;
    }
    void circle(const Place& middle, const Place& one, const Place& other, std::uint8_t colour) {
        constexpr int kParts = 48;
        const auto on_it = [&](int part) {
            const double angle = part * 2 * std::numbers::pi / kParts, c = std::cos(angle), s = std::sin(angle);
            return Place{middle.x + c * one.x + s * other.x, middle.y + c * one.y + s * other.y,
                         middle.z + c * one.z + s * other.z};
        };
        for (int part = 0; part < kParts; ++part) line(on_it(part), on_it(part + 1), colour);
    }
    void label(const Place& place, std::string_view text) {
        const PixelPlace pixel = shown(place, view_);
        draw_text(canvas_, static_cast<std::int32_t>(pixel.x) + 2, static_cast<std::int32_t>(pixel.y) - 4, text,
                  assets_.text);
    }

  private:
    const GalleryAssets& assets_;
    Framebuffer canvas_;
    ScreenPolygon polygon_;
    ScanlineExtents rows_;
    ViewContext view_;
};

/// A cube's corner: bit 0 of its number is x, bit 1 y, bit 2 z.
struct Cube {
    Place low;
    double size = 100;

    Place corner(int number) const {
        return {low.x + (number & 1 ? size : 0), low.y + (number & 2 ? size : 0), low.z + (number & 4 ? size : 0)};
    }
};
/// Clockwise seen from outside: top, south, east, and the three opposite.
constexpr std::array<std::array<int, 4>, 6> kCubeFaces{
    {{4, 6, 7, 5}, {0, 4, 5, 1}, {1, 5, 7, 3}, {0, 1, 3, 2}, {3, 7, 6, 2}, {2, 6, 4, 0}}};

Place half_of(const Place& from, const Place& to) {
    return {(to.x - from.x) / 2, (to.y - from.y) / 2, (to.z - from.z) / 2};
}

/// The cube's faces with a circle in each, then its edges; those behind are dim.
void draw_cube(const Cube& cube, const GalleryAssets& assets, WireScene& scene) {
    const std::array<std::uint8_t, 3> colours{assets.colour(96, 112, 140), assets.colour(64, 76, 104),
                                              assets.colour(46, 54, 78)};
    std::array<bool, 6> is_front{};
    for (std::size_t face = 0; face < 6; ++face) {
        std::array<Place, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) corners[i] = cube.corner(kCubeFaces[face][i]);
        is_front[face] = scene.polygon(corners, colours[face % 3]);
        const Place one = half_of(corners[0], corners[1]), other = half_of(corners[0], corners[3]);
        const Place middle{corners[0].x + one.x + other.x, corners[0].y + one.y + other.y,
                           corners[0].z + one.z + other.z};
        if (is_front[face]) scene.circle(middle, one, other, assets.colour(220, 150, 60));
    }
    for (const bool front : {false, true})
        for (std::size_t face = 0; face < 6; ++face)
            for (std::size_t i = 0; i < 4 && is_front[face] == front; ++i)
                scene.line(cube.corner(kCubeFaces[face][i]), cube.corner(kCubeFaces[face][(i + 1) % 4]),
                           front ? assets.colour(230, 230, 240) : assets.colour(90, 96, 120));
}

void draw_axes(const Place& origin, double length, const GalleryAssets& assets, WireScene& scene) {
    const std::array<Place, 3> ends{{{origin.x + length, origin.y, origin.z},
                                     {origin.x, origin.y + length, origin.z},
                                     {origin.x, origin.y, origin.z + length}}};
    const std::array<std::uint8_t, 3> colours{assets.colour(220, 80, 70), assets.colour(100, 200, 90),
                                              assets.colour(90, 140, 240)};
    constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        scene.line(origin, ends[axis], colours[axis]);
        scene.label(ends[axis], kNames[axis]);
    }
}

constexpr Cube kCube{{-50, -50, -50}, 100};
constexpr double kCubeWidth = 340;  ///< units across the screen
const Vec3<World> kLevelCentre{World::from_int(300), World::from_int(800), World::from_int(40)};

/// The cube in the middle of what header and footer leave.
void draw_cube_scene(const RowInput& input, const ViewSpec& view, Framebuffer canvas) {
    const Ratio pixel = input.mode.pixel();
    const double unit_px = input.mode.width_px / kCubeWidth * static_cast<double>(pixel.numerator) /
                           static_cast<double>(pixel.denominator);
    const double down = (kFooter_px - kHeader_px) / 2.0 / unit_px;
    ViewSpec moved = view;
    moved.eye = in_world(
        {-down * number_of(view.axes.up.x), -down * number_of(view.axes.up.y), -down * number_of(view.axes.up.z)});
    WireScene scene(input, moved, canvas);
    scene.fill_background();
    draw_cube(kCube, input.assets, scene);
    draw_axes(kCube.low, 145, input.assets, scene);
}

ViewContext context_of(const RowInput& input, const ViewSpec& view) {
    return make_view_context(view, input.mode);
}

const Place kX{50, -50, -50}, kY{-50, 50, -50}, kZ{-50, -50, 50};

/// How long the cube's edges along x, y and z are in the picture, against factors of their true length.
std::vector<Figure> edge_figures(const RowInput& input, const ViewSpec& view, const std::array<double, 3>& factors) {
    const ViewContext context = context_of(input, view);
    const double true_length = 100 * input.mode.width_px / kCubeWidth;
    const std::array<const Place*, 3> ends{&kX, &kY, &kZ};
    constexpr std::array<const char*, 3> kNames{"edge along x / its true length", "along y", "along z"};
    std::vector<Figure> figures;
    for (std::size_t axis = 0; axis < 3; ++axis)
        figures.push_back(number_figure(kNames[axis], factors[axis],
                                        length_on_display(kCube.low, *ends[axis], context, input.mode) / true_length,
                                        0.001));
    return figures;
}

RowPage draw_orthographic(const RowInput& input, Framebuffer canvas) {
    const auto side = static_cast<ViewSide>(input.values[0]);
    const ViewSpec view = orthographic_view({}, side_axes(side), View::from_int(static_cast<std::int64_t>(kCubeWidth)));
    draw_cube_scene(input, view, canvas);
    constexpr std::array<std::array<double, 3>, 3> kFactors{{{1, 0, 1}, {1, 1, 0}, {0, 1, 1}}};
    return {edge_figures(input, view, at(kFactors, static_cast<std::int32_t>(input.values[0]))),
            {"The direction of projection is at right angles to the view plane: a coordinate is thrown away, and the "
             "others keep their lengths.",
             "1/z is the same everywhere, so that a texture needs one division a row."}};
}

RowPage draw_axonometric(const RowInput& input, Framebuffer canvas) {
    const auto kind = static_cast<Axonometry>(input.values[0]);
    const Angle turn = degrees_to_angle(Degrees::from_int(90 * input.values[1]));
    const ViewSpec view =
        orthographic_view({}, axonometric_axes(kind, turn), View::from_int(static_cast<std::int64_t>(kCubeWidth)));
    draw_cube_scene(input, view, canvas);
    // An axis is shortened to the root of 1 less its squared part along the rays.
    const double equal = std::sqrt(2 / 3.0), root2 = std::sqrt(2);
    const std::array<std::array<double, 3>, 3> factors{
        {{equal, equal, equal},
         {root2 / 3, 2 * root2 / 3, 2 * root2 / 3},
         {std::sqrt(8 / 17.0), std::sqrt(13 / 17.0), std::sqrt(13 / 17.0)}}};
    std::array<double, 3> here = at(factors, static_cast<std::int32_t>(input.values[0]));
    if (input.values[1] % 2 == 1) std::swap(here[0], here[1]);
    return {
        edge_figures(input, view, here),
        {"Orthographic, but along no axis: all three are seen. Isometric shortens them alike, dimetric two of them, "
         "trimetric each by a factor of its own."}};
}

ViewSpec oblique_cube_view(double length, std::int64_t degrees) {
    return oblique_view({}, side_axes(ViewSide::Front), View::from_int(static_cast<std::int64_t>(kCubeWidth)),
                        Unit::from_raw(static_cast<std::int32_t>(std::ldexp(length, 30))),
                        degrees_to_angle(Degrees::from_int(degrees)));
}

RowPage draw_oblique(const RowInput& input, Framebuffer canvas) {
    const double length = input.values[0] == 0 ? 1 : 0.5, degrees = static_cast<double>(input.values[1]);
    const ViewSpec view = oblique_cube_view(length, input.values[1]);
    draw_cube_scene(input, view, canvas);
    std::vector<Figure> figures = edge_figures(input, view, {1, length, 1});
    const ViewContext context = context_of(input, view);
    figures.push_back(number_figure("right per unit of depth, L cos a",
                                    length * std::cos(degrees * std::numbers::pi / 180),
                                    across(kCube.low, kY, context) / across(kCube.low, kX, context), 0.001));
    return {std::move(figures),
            {"The direction of projection is not at right angles to the view plane. The front keeps its shape; what is "
             "farther is shifted by L of its depth: 1 in a cavalier projection, 1/2 in a cabinet one.",
             "It is a shear, as is an off-centre window: the view's axes lose it, and the rest is as always."}};
}

/// Views of the demo level from outside.
ViewSpec level_view(std::int64_t choice) {
    constexpr View kWidth = View::from_int(2300);
    if (choice < 3) return orthographic_view(kLevelCentre, axonometric_axes(static_cast<Axonometry>(choice)), kWidth);
    // From above, so that what is higher rises to the upper right.
    return oblique_view(kLevelCentre, side_axes(ViewSide::Top), kWidth, Unit::from_raw(choice == 3 ? 1 << 30 : 1 << 29),
                        Angle{0xa000});
}

RowPage draw_level_from_outside(const RowInput& input, Framebuffer canvas) {
    const Level& level = input.assets.demo_level;
    ViewSpec view = level_view(input.values[0]);
    cut_above(view, World::from_int(static_cast<std::int32_t>(input.values[1])));
    const std::vector<PlacedModel> models = models_at_rest(level);
    FrameWorkspace work(level, input.mode);
    work.counts = std::make_unique<FrameCounts>();
    draw_frame({level, input.assets.colormap, models, input.time_ms}, view, input.mode, input.settings, work, canvas);
    std::int64_t twice = 0, never = 0;
    for (const std::uint8_t writes : work.counts->writes) {
        twice += writes > 1;
        never += writes == 0;
    }
    return {
        {count_figure("pixels that faces draw twice", 0, twice),
         measured("pixels that show nothing", std::to_string(never)),
         measured("faces that own pixels", std::to_string(work.counts->faces_drawn))},
        {"Seen from outside, a level's walls and ceilings on this side face away and are culled: its rooms are open. "
         "A section takes off what is above a height.",
         "Order and culling ask for sides of a direction instead of a point, in homogeneous coordinates: w = 0."}};
}

/// A camera whose picture of the cube has so many vanishing points.
Camera camera_with_points(int points) {
    constexpr std::array<Place, 3> kEyes{{{110, -310, 100}, {-160, -160, 15}, {-140, -140, 150}}};
    Camera camera;
    camera.eye = in_world(at(kEyes, points - 1));
    camera.yaw = degrees_to_angle(Degrees::from_int(points == 1 ? 90 : 45));
    camera.pitch = degrees_to_angle(Degrees::from_int(points == 3 ? 38 : 0));
    camera.field_of_view = Degrees::from_int(100);
    return camera;
}

/// Where lines along an axis meet: the picture of a direction, x m / z; none for lines along the view plane.
std::optional<PixelPlace> vanishing_point(const Vec3<Unit>& axis, const ViewContext& view) {
    const auto part = [&](const Vec3<Unit>& of_view) { return std::ldexp(dot(axis, of_view).raw, -60); };
    const double z = part(view.axes.forward);
    if (std::abs(z) < 1e-6) return std::nullopt;
    const auto pixels = [](Multiplier multiplier) { return std::ldexp(static_cast<double>(multiplier.raw), -32); };
    return PixelPlace{view.projection.width_px / 2.0 + pixels(view.projection.x.multiplier) * part(view.axes.right) / z,
                      view.projection.height_px / 2.0 - pixels(view.projection.y.multiplier) * part(view.axes.up) / z};
}

RowPage draw_vanishing_points(const RowInput& input, Framebuffer canvas) {
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
        const std::optional<PixelPlace> point = vanishing_point(axes[axis], scene.view());
        if (!point) continue;
        ++found;
        for (int corner = 0; corner < 8; ++corner)
            scene.line(shown(kCube.corner(corner), scene.view()), *point, colours[axis]);
        // As the engine projects a place 2^18 units from the eye, ahead of it.
        Place far{std::ldexp(camera.eye.x.raw, -12), std::ldexp(camera.eye.y.raw, -12),
                  std::ldexp(camera.eye.z.raw, -12)};
        const double way = dot(axes[axis], scene.view().axes.forward) > Sine60{} ? 262144 : -262144;
        (axis == 0 ? far.x : axis == 1 ? far.y : far.z) += way;
        const PixelPlace seen = shown(far, scene.view());
        worst_px = std::max(worst_px, std::hypot(seen.x - point->x, seen.y - point->y));
    }
    draw_cube(kCube, input.assets, scene);
    return {{count_figure("axes that have a vanishing point", points, found),
             number_figure("pixels to what is 2^18 units along", 0, worst_px, 0.02)},
            {"Lines along an axis meet in the picture of its direction: centre + m (axis . right) / (axis . forward). "
             "An axis along the view plane has none: its lines stay parallel."}};
}

/// The lab's cube and window: as its text has them with a window of 1 moved by `moved` and a COP `distance` before the
/// plane.
WindowView lab_window(double distance, double moved) {
    WindowView window;
    window.reference_point = in_world({0.5, 0.5, -2});
    window.normal = in_world({0, 0, -1});
    window.up = in_world({0, 1, 0});
    window.centre_of_projection = in_world({0.5, 0.5, -2 - distance});
    const Vec3<World> low = in_world({moved - 0.5, -0.5, 0}), high = in_world({moved + 0.5, 0.5, 0});
    window.u_min = low.x, window.v_min = low.y;
    window.u_max = high.x, window.v_max = high.y;
    return window;
}

RowPage draw_lab_cube(const RowInput& input, Framebuffer canvas) {
    const double distance = static_cast<double>(input.values[0]) / 2, moved = static_cast<double>(input.values[1]) / 10;
    const ViewSpec spec = window_view(lab_window(distance, moved));
    WireScene scene(input, spec, canvas);
    scene.fill_background();
    const Cube cube{{0, 0, 0}, 1};
    const auto on_plane = [&](double u, double v) { return Place{0.5 - u, 0.5 + v, -2}; };
    const std::array<Place, 4> window{on_plane(moved - 0.5, -0.5), on_plane(moved - 0.5, 0.5),
                                      on_plane(moved + 0.5, 0.5), on_plane(moved + 0.5, -0.5)};
    draw_cube(cube, input.assets, scene);
    for (std::size_t i = 0; i < 4; ++i) scene.line(window[i], window[(i + 1) % 4], input.assets.colour(120, 150, 90));
    draw_axes({0, 0, 0}, 1.3, input.assets, scene);

    // In the lab's 200x200 pixels: u is VUP x VPN, so that x grows to the left.
    const ViewContext lab = make_view_context(spec, {200, 200, {1, 1}});
    const auto column = [&](double x, double depth) {
        return 100 + 200 * ((0.5 - x) * distance / (distance + depth) - moved);
    };
    const auto row = [&](double y, double depth) { return 100 - 200 * (y - 0.5) * distance / (distance + depth); };
    return {
        {number_figure("(0, 0, 1): column (the seed's table: 175)", column(0, 3), shown({0, 0, 1}, lab).x, 0.01, 1),
         number_figure("(1, 0, 1): column (the table: 75)", column(1, 3), shown({1, 0, 1}, lab).x, 0.01, 1),
         number_figure("far / near face, (d + 2) / (d + 3) (the table: 1)", (distance + 2) / (distance + 3),
                       across({0, 0, 1}, {1, 0, 1}, lab) / across({0, 0, 0}, {1, 0, 0}, lab), 0.001),
         number_figure("(0, 0, 0): column", column(0, 2), shown({0, 0, 0}, lab).x, 0.01, 1),
         number_figure("(0, 0, 1): row", row(0, 3), shown({0, 0, 1}, lab).y, 0.01, 1)},
        {"VRP, VPN, VUP, COP and a window (the green square), which may be off-centre. The seed's table has the far "
         "face as large as the near one: that would be an oblique parallel projection.",
         "Right-handed axes, VPN toward the viewer: u = VUP x VPN points along -x."}};
}

/// The highest place that a plan of the demo level shows, and draws the plan.
double draw_plan(const RowInput& input, const ViewSpec& view, Framebuffer canvas) {
    const Level& level = input.assets.demo_level;
    FrameWorkspace work(level, input.mode);
    work.record = std::make_unique<FrameRecord>();
    draw_frame({level, input.assets.colormap, {}, input.time_ms}, view, input.mode, input.settings, work, canvas);
    const double per_column =
        2 * std::ldexp(static_cast<double>(view.window.half_width.raw), -16) / input.mode.width_px;
    const Ratio pixel = input.mode.pixel();
    const double per_row = per_column * static_cast<double>(pixel.denominator) / static_cast<double>(pixel.numerator);
    double highest = -1e9;
    for (std::int32_t row = 0; row < input.mode.height_px; ++row)
        for (std::int32_t column = 0; column < input.mode.width_px; ++column) {
            const PixelRecord& shows = at(work.record->pixels, row * canvas.pitch + column);
            if (shows.face.is_none()) continue;
            const LevelPlane& plane = level.planes[level.faces[shows.face].plane];
            const double x = std::ldexp(view.eye.x.raw, -12) + (column + 0.5 - input.mode.width_px / 2.0) * per_column;
            const double y = std::ldexp(view.eye.y.raw, -12) - (row + 0.5 - input.mode.height_px / 2.0) * per_row;
            const double way = std::ldexp(static_cast<double>(plane.distance.raw), -42) -
                               number_of(plane.normal.x) * x - number_of(plane.normal.y) * y;
            if (std::abs(number_of(plane.normal.z)) > 0.1) highest = std::max(highest, way / number_of(plane.normal.z));
        }
    return highest;
}

RowPage draw_front_plane(const RowInput& input, Framebuffer canvas) {
    const auto height = static_cast<std::int32_t>(input.values[0]);
    ViewSpec view = orthographic_view(kLevelCentre, side_axes(ViewSide::Top), View::from_int(2300));
    cut_front(view, kLevelCentre, kLevelCentre.z - World::from_int(height));
    RowInput with_pixels = input;
    with_pixels.settings.correct_aspect = true;
    const double highest = draw_plan(with_pixels, view, canvas);
    return {{{"highest place shown", "at most " + std::to_string(height), text_of("%.1f", highest),
              highest <= height + 0.5},
             measured("front plane, units below the reference point", std::to_string(40 - height))},
            {"What is before the front plane is cut off in the world, before it is projected: from above that makes a "
             "floor plan. So is what is behind a back plane.",
             "Views without these planes have no near plane: the sides of the view meet in the eye."}};
}

constexpr double kSphereDistance = 300;

/// Before the demo level's sphere: the field of view changes, and the eye moves against it or not.
RowPage draw_dolly_zoom(const RowInput& input, Framebuffer canvas) {
    const bool moves = input.values[1] == 0;
    constexpr std::array<int, 4> kDegrees{20, 40, 60, 90};
    const int degrees = at(kDegrees, static_cast<std::int32_t>(input.values[0]));
    const Degrees field_of_view = Degrees::from_int(degrees);
    const Camera before = camera_at(-112, 352 - 300, 128, 90, 0, 60);
    Camera camera = before;
    camera.field_of_view = field_of_view;
    if (moves) camera = dolly_zoomed(before, World::from_int(300), field_of_view);
    ViewSpec view = first_person_view(camera);
    if (moves) cut_front(view, before.eye, World::from_int(8));
    draw_demo_level(input, view, canvas);

    const auto tangent = [](double angle) { return std::tan(angle * std::numbers::pi / 360); };
    const double wide = tangent(degrees);
    const double distance = moves ? kSphereDistance * tangent(60) / wide : kSphereDistance;
    const ViewContext context = make_view_context(view, input.mode);
    const auto size_at = [&](double y) { return across({-162, y, 128}, {-62, y, 128}, context); };
    const double half_px = input.mode.width_px / 2.0;
    return {
        {number_figure("100 units at the sphere, columns", half_px * 100 / (distance * wide), size_at(352), 0.1, 2),
         number_figure("the same 200 units behind it", half_px * 100 / ((distance + 200) * wide), size_at(552), 0.1, 2),
         number_figure("behind / there = D / (D + 200)", distance / (distance + 200), size_at(552) / size_at(352),
                       0.001)},
        {"Moving the eye changes how much smaller the far is; the field of view crops, and changes that not at all "
         "(the seed has it that a smaller window flattens too).",
         "With both, what is in the middle keeps its size, and the room behind it grows or shrinks."}};
}

/// A small cross at a pixel.
void draw_cross(const PixelPlace& at, std::uint8_t colour, std::uint8_t dark, Framebuffer canvas) {
    const auto x = static_cast<std::int32_t>(std::floor(at.x)), y = static_cast<std::int32_t>(std::floor(at.y));
    fill_area(canvas, {x - 6, y - 1, 13, 3}, dark);
    fill_area(canvas, {x - 1, y - 6, 3, 13}, dark);
    fill_area(canvas, {x - 5, y, 11, 1}, colour);
    fill_area(canvas, {x, y - 5, 1, 11}, colour);
}

RowPage draw_cameras(const RowInput& input, Framebuffer canvas) {
    const bool looks_at = input.values[0] == 0;
    const double yaw = static_cast<double>(input.values[1]) * std::numbers::pi / 180;
    const Place sphere{-112, 352, 128};
    const Place eye = looks_at ? Place{sphere.x - 150 * std::cos(yaw), sphere.y - 150 * std::sin(yaw), sphere.z + 30}
                               : Place{-112, 202, 128};
    const Place target = looks_at ? sphere : Place{eye.x + 100 * std::cos(yaw), eye.y + 100 * std::sin(yaw), eye.z};
    ViewSpec view = look_at_view(in_world(eye), in_world(target), Degrees::from_int(90));
    if (!looks_at) view = first_person_view(camera_at(-112, 202, 128, static_cast<int>(input.values[1]), 0));
    draw_demo_level(input, view, canvas);
    const ViewContext context = make_view_context(view, input.mode);
    const PixelPlace found = shown(target, context), above = shown({target.x, target.y, target.z + 20}, context);
    draw_cross(found, input.assets.colour(240, 220, 90), input.assets.colour(0, 0, 0), canvas);
    const double width = input.mode.width_px, height = input.mode.height_px;
    return {{number_figure(looks_at ? "the target's column" : "the column of what is straight ahead", width / 2,
                           found.x, width / 2000, 2),
             number_figure("its row", height / 2, found.y, width / 2000, 2),
             number_figure("columns from there to what is above it", 0, above.x - found.x, width / 2000, 2)},
            {"Look-at: axes from the eye, a target and an up. First-person: axes from yaw, pitch and roll, one after "
             "the other. Both end in the same three axes."}};
}

std::string row_of(double a, double b, double c, double d) {
    char text[64];
    std::snprintf(text, sizeof text, "[%7.3f %7.3f %7.3f %9.2f ]", a, b, c, d);
    return text;
}

/// The matrix of a view, from its axes, and its inverse.
RowPage draw_view_matrix(const RowInput& input, Framebuffer canvas) {
    fill_area(canvas, {0, 0, canvas.width_px, canvas.height_px}, input.assets.colour(20, 24, 36));
    const Camera camera = camera_at(60, -120, 70, static_cast<int>(input.values[0]), static_cast<int>(input.values[1]));
    const ViewContext view = make_view_context(first_person_view(camera), input.mode);
    const std::array<const Vec3<Unit>*, 3> rows{&view.axes.right, &view.axes.up, &view.axes.forward};
    const std::array<double, 3> eye{60, -120, 70};
    std::array<std::array<double, 4>, 3> there{}, back{};
    for (std::size_t i = 0; i < 3; ++i) {
        there[i] = {number_of(rows[i]->x), number_of(rows[i]->y), number_of(rows[i]->z), 0};
        for (std::size_t j = 0; j < 3; ++j) there[i][3] -= there[i][j] * eye[j];
    }
    for (std::size_t i = 0; i < 3; ++i) back[i] = {there[0][i], there[1][i], there[2][i], eye[i]};
    double flaw = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            double sum = j == 3 ? there[i][3] : 0;
            for (std::size_t k = 0; k < 3; ++k) sum += there[i][k] * back[k][j];
            flaw = std::max(flaw, std::abs(sum - (i == j ? 1 : 0)));
        }
    std::int32_t y = kHeader_px + (canvas.height_px - kHeader_px - kFooter_px - 126) / 2;
    const std::int32_t x = std::max(canvas.width_px / 2 - 118, 4);
    const auto write = [&](std::string_view line) {
        draw_text(canvas, x, y, line, input.assets.text);
        y += 12;
    };
    write("The camera's matrix: right, up, forward, eye");
    for (const auto& row : back) write(row_of(row[0], row[1], row[2], row[3]));
    write(row_of(0, 0, 0, 1));
    y += 6;
    write("Its inverse, the view's: rows, -axis . eye");
    for (const auto& row : there) write(row_of(row[0], row[1], row[2], row[3]));
    write(row_of(0, 0, 0, 1));
    const Vec3<View> seen = to_view(in_world({160, -20, 90}), view);
    const double expected = there[0][0] * 160 + there[0][1] * -20 + there[0][2] * 90 + there[0][3];
    return {{number_figure("product of both, less the identity: worst entry", 0, flaw, 1e-6, 6),
             number_figure("(160, -20, 90): x in view, by the engine", expected,
                           std::ldexp(static_cast<double>(seen.x.raw), -16), 0.001)},
            {"The camera's axes and eye are the columns of the matrix from view to world. Axes at right angles: the "
             "inverse is the transpose, and the eye goes to minus its dot products with them."}};
}

}  // namespace

std::vector<Row> view_rows() {
    constexpr std::string_view kViews = "engine/geometry/views.h", kTest = "tests/geometry/views_test.cpp",
                               kFrames = "tests/frame/view_frames_test.cpp";
    return {{"view-window",
             "A view by VRP, VPN, VUP, COP and window",
             "2 Lab: 3-D Perspective Viewing Pipeline",
             kViews,
             kTest,
             {{"COP before the plane, halves", 2, 16, 1, 4}, {"window moved, tenths", -5, 5, 1, 0}},
             draw_lab_cube},
            {"front-plane",
             "Front plane: a floor plan",
             "2 Lab: 3-D Perspective Viewing Pipeline",
             kViews,
             kFrames,
             {{"height", -50, 400, 50, 50}},
             draw_front_plane},
            {"zoom-dolly",
             "Zoom against dolly",
             "2 Lab: 3-D Perspective Viewing Pipeline",
             kViews,
             kTest,
             {choice_parameter("field of view", {"20 degrees", "40 degrees", "60 degrees", "90 degrees"}, 1),
              choice_parameter("the eye", {"moves against it", "stays"})},
             draw_dolly_zoom},
            {"cameras",
             "Look-at and first-person cameras",
             "3 Notes: Camera",
             kViews,
             kTest,
             {choice_parameter("camera", {"look-at", "first-person"}), {"yaw", 0, 345, 15, 60}},
             draw_cameras},
            {"camera-matrix",
             "A camera's matrix and its inverse",
             "4 Princeton: Camera; 3 Notes: Camera",
             "engine/geometry/view_spec.cpp",
             kTest,
             {{"yaw", 0, 345, 15, 30}, {"pitch", -60, 60, 10, 10}},
             draw_view_matrix},
            {"orthographic",
             "Orthographic: front, top and side",
             "4 Princeton: Projection; 2 Lab",
             kViews,
             kTest,
             {choice_parameter("view", {"front", "top", "side"})},
             draw_orthographic},
            {"axonometric",
             "Isometric, dimetric, trimetric",
             "4 Princeton: Projection",
             kViews,
             kTest,
             {choice_parameter("view", {"isometric", "dimetric", "trimetric"}), {"quarters turned", 0, 3, 1, 0}},
             draw_axonometric},
            {"oblique",
             "Oblique: cavalier and cabinet",
             "4 Princeton: Projection",
             kViews,
             kTest,
             {choice_parameter("view", {"cavalier", "cabinet"}), {"angle", 0, 90, 15, 45}},
             draw_oblique},
            {"level-from-outside",
             "A level from outside",
             "4 Princeton: Projection",
             kViews,
             kFrames,
             {choice_parameter("view", {"isometric", "dimetric", "trimetric", "cavalier plan", "cabinet plan"}),
              {"cut off above", 0, 640, 80, 80}},
             draw_level_from_outside},
            {"vanishing-points",
             "Vanishing points: one, two, three",
             "4 Princeton: Projection",
             "engine/geometry/project.h",
             kTest,
             {choice_parameter("vanishing points", {"one", "two", "three"}, 1)},
             draw_vanishing_points}};
}

}  // namespace oblong
