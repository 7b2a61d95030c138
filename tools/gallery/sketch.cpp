#include "tools/gallery/sketch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/table.h"
#include "engine/fixed/trig.h"
#include "engine/methods/canonical_volume.h"
#include "engine/raster/lines.h"
#include "engine/view/project.h"

namespace oblong {

namespace {

constexpr double kNearest = 0.25, kFarthest = 8192;

Screen screen_of(Entry pixels) {
    return convert<Screen>(convert<ScreenWide>(pixels));
}

PixelPosition pixel_at(const ScreenVertex& vertex, Framebuffer part) {
    const auto within = [](Screen at, std::int32_t size_px) {
        return std::clamp(floor_of(at), 0, std::max(size_px - 1, 0));  // a part may be empty
    };
    return {within(vertex.x, part.width_px), within(vertex.y, part.height_px)};
}

void fill_rows(const ScanlineExtents& rows, std::uint8_t index, Framebuffer canvas) {
    for (std::int32_t y = rows.first; y < rows.end; ++y)
        if (item(rows.left, y) < item(rows.right, y))
            fill_area(canvas, {item(rows.left, y), y, item(rows.right, y) - item(rows.left, y), 1}, index);
}

/// Clockwise seen from outside: top, south, east, and the three opposite.
constexpr std::array<std::array<int, 4>, 6> kCubeFaces{
    {{4, 6, 7, 5}, {0, 4, 5, 1}, {1, 5, 7, 3}, {0, 1, 3, 2}, {3, 7, 6, 2}, {2, 6, 4, 0}}};

constexpr Vec kOutOfView{-1, -1};

struct NamedAxis {
    std::string_view name;
    Rgb8 in_sketch, in_wires;
};
constexpr std::array<NamedAxis, 3> kNamedAxes{{{"x", kScarlet, kRed}, {"y", kLeaf, kGreen}, {"z", kBlue, kBlue}}};

}  // namespace

Sketch::Sketch(const Canvas& canvas, const Area& area, const SketchEye& from) : Canvas(canvas.part(area)) {
    view_ = make_view_context(
        look_at_view(world_point(from.eye), world_point(from.target), Degrees::from_int(from.field_of_view)),
        mode_of_part(input.mode, *this));
    world_to_volume_ =
        volume_matrix(view_.projection, entry_of(kNearest), entry_of(kFarthest)) * view_matrix(view_.axes, view_.eye);
}

std::vector<ScreenVertex> Sketch::clipped(std::span<const DrawnPoint> corners) const {
    std::vector<Vec4> polygon;
    for (const DrawnPoint& p : corners) polygon.push_back(world_to_volume_ * homogeneous(world_point(p)));
    std::vector<ScreenVertex> screen;
    for (const Vec4& corner : clip_to_volume(polygon)) {
        const VolumeScreenPoint at = volume_to_screen(corner, width_px, height_px);
        screen.push_back({screen_of(at.x), screen_of(at.y)});
    }
    return screen;
}

void Sketch::line(const DrawnPoint& from, const DrawnPoint& to, Rgb8 colour) {
    const std::vector<ScreenVertex> ends = clipped(std::array{from, to});
    if (ends.empty()) return;
    // Clipping returns crossings twice, once for each direction of the edge.
    const auto way = [&](const ScreenVertex& v) {
        return absolute(v.x - ends.front().x) + absolute(v.y - ends.front().y);
    };
    const auto farthest = std::max_element(
        ends.begin(), ends.end(), [&](const ScreenVertex& a, const ScreenVertex& b) { return way(a) < way(b); });
    draw_line(pixel_at(ends.front(), *this), pixel_at(*farthest, *this), {LineMethod::Bresenham, input.colour(colour)},
              *this);
}

void Sketch::fill_polygon(const std::vector<DrawnPoint>& corners, Rgb8 colour) {
    std::vector<ScreenVertex> screen = clipped(corners);
    if (screen.size() < 3) return;
    if (doubled_area(screen) < ScreenArea{}) std::reverse(screen.begin(), screen.end());
    ScanlineExtents rows(height_px);
    scan_convex(screen, rows);
    fill_rows(rows, input.colour(colour), *this);
}

void Sketch::axes(const std::array<DrawnPoint, 3>& ends) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        line({0, 0}, ends[axis], kNamedAxes[axis].in_sketch);
        label(ends[axis], kNamedAxes[axis].name, kNamedAxes[axis].in_sketch);
    }
}

void Sketch::label(const DrawnPoint& at, std::string_view text, Rgb8 colour) {
    if (pixel_of(at) != kOutOfView) Canvas::label(at, text, colour, 3, -9);
}

Vec Sketch::pixel_of(const Vec& point) const {
    const Vec4 corner = world_to_volume_ * homogeneous(world_point(point));
    if (volume_outcode(corner) != 0) return kOutOfView;
    const VolumeScreenPoint at = volume_to_screen(corner, width_px, height_px);
    return {number_of(at.x), number_of(at.y)};
}

Vec shown(const Vec& place, const ViewContext& view) {
    const ScreenPosition position = project(to_view(world_point(place), view), view.projection);
    return {number_of(position.x), number_of(position.y)};
}

double across(const Vec& from, const Vec& to, const ViewContext& view) {
    return std::abs(shown(to, view).x - shown(from, view).x);
}

WireScene::WireScene(const Canvas& canvas, const ViewSpec& spec)
    : Canvas(canvas),
      rows_(canvas.height_px),
      view_(make_view_context(spec, input.mode, {30, View::kFractionBits, 8, input.settings.correct_aspect})) {}

bool WireScene::polygon(std::span<const Vec> corners, Rgb8 colour) {
    std::vector<Vec3<World>> world;
    for (const Vec& corner : corners) world.push_back(world_point(corner));
    if (!project_polygon(world, view_, polygon_) || doubled_area(polygon_.vertices) <= ScreenArea{}) return false;
    scan_convex(polygon_.vertices, rows_);
    fill_rows(rows_, input.colour(colour), *this);
    return true;
}

void WireScene::cube(const Cube& cube) {
    constexpr std::array kSides{kGrey, Rgb8{64, 76, 104}, kShadow};
    std::array<bool, 6> is_front{};
    for (std::size_t face = 0; face < 6; ++face) {
        std::array<Vec, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) corners[i] = cube.corner(kCubeFaces[face][i]);
        is_front[face] = polygon(corners, kSides[face % 3]);
        const Vec one = (corners[1] - corners[0]) * 0.5, other = (corners[3] - corners[0]) * 0.5;
        if (is_front[face]) ellipse(corners[0] + one + other, one, other, 48, kAmber);
    }
    for (const bool front : {false, true})
        for (std::size_t face = 0; face < 6; ++face)
            for (std::size_t i = 0; i < 4 && is_front[face] == front; ++i)
                line(cube.corner(kCubeFaces[face][i]), cube.corner(kCubeFaces[face][(i + 1) % 4]),
                     front ? kWhite : kFaint);
}

void WireScene::axes(const Vec& origin, double length) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Vec end = origin;
        end[axis] += length;
        line(origin, end, kNamedAxes[axis].in_wires);
        label(end, kNamedAxes[axis].name, kBright, 2);
    }
}

WindowView lab_window(double distance, double size, double moved) {
    WindowView window;
    window.reference_point = world_point(0.5, 0.5, -2);
    window.normal = world_point(0, 0, -1);
    window.up = world_point(0, 1, 0);
    window.centre_of_projection = world_point(0.5, 0.5, -2 - distance);
    const Vec3<World> low = world_point(moved - size / 2, -size / 2, 0),
                      high = world_point(moved + size / 2, size / 2, 0);
    window.u_min = low.x, window.v_min = low.y;
    window.u_max = high.x, window.v_max = high.y;
    return window;
}

Vec3<World> middle_of_demo_level() {
    return world_point(300, 800, 40);
}

Camera camera_at(std::int32_t x, std::int32_t y, std::int32_t z, std::int64_t yaw, std::int64_t pitch,
                 int field_of_view) {
    return {{World::from_int(x), World::from_int(y), World::from_int(z)},
            degrees_to_angle(Degrees::from_int(yaw)),
            degrees_to_angle(Degrees::from_int(pitch)),
            {},
            Degrees::from_int(field_of_view)};
}

DemoFrame::DemoFrame(const RowInput& input, const ScreenMode& of_mode)
    : settings(input.settings),
      mode(of_mode),
      models(models_at_rest(input.assets.demo_level)),
      scene{input.assets.demo_level, input.assets.colormap, models, input.time_ms},
      work(input.assets.demo_level, mode) {}

void DemoFrame::draw(const ViewSpec& view, Framebuffer canvas) {
    draw_frame(scene, view, mode, settings, work, canvas);
}

void DemoFrame::draw(const Camera& camera, Framebuffer canvas) {
    draw(first_person_view(camera, settings.accuracy.sine), canvas);
}

}  // namespace oblong
