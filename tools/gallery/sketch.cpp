#include "tools/gallery/sketch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/base/table.h"
#include "engine/draw/drawing.h"
#include "engine/fixed/trig.h"
#include "engine/math/matrix.h"
#include "engine/methods/canonical_volume.h"
#include "engine/raster/lines.h"
#include "engine/raster/scan.h"
#include "engine/view/project.h"
#include "engine/view/views.h"
#include "tools/gallery/row.h"

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

/// Clockwise seen from outside: top, south, east, and the three opposite.
constexpr std::array<std::array<int, 4>, 6> kCubeFaces{
    {{4, 6, 7, 5}, {0, 4, 5, 1}, {1, 5, 7, 3}, {0, 1, 3, 2}, {3, 7, 6, 2}, {2, 6, 4, 0}}};

}  // namespace

Sketch::Sketch(const RowInput& input, Framebuffer canvas, const Area& area, const SketchEye& from)
    : part_(part_of(canvas, area)), text_(input.assets.text) {
    view_ = make_view_context(look_at_view(from.eye, from.target, Degrees::from_int(from.field_of_view)),
                              mode_of_part(input.mode, part_));
    world_to_volume_ =
        volume_matrix(view_.projection, entry_of(kNearest), entry_of(kFarthest)) * view_matrix(view_.axes, view_.eye);
}

std::vector<ScreenVertex> Sketch::clipped(std::span<const Vec3<World>> corners) const {
    std::vector<Vec4> polygon;
    for (const Vec3<World>& p : corners) polygon.push_back(world_to_volume_ * homogeneous(p));
    std::vector<ScreenVertex> screen;
    for (const Vec4& corner : clip_to_volume(polygon)) {
        const VolumeScreenPoint at = volume_to_screen(corner, part_.width_px, part_.height_px);
        screen.push_back({screen_of(at.x), screen_of(at.y)});
    }
    return screen;
}

void Sketch::line(const Vec3<World>& from, const Vec3<World>& to, std::uint8_t colour) {
    const std::vector<ScreenVertex> ends = clipped(std::array{from, to});
    if (ends.empty()) return;
    // Clipping returns crossings twice, once for each direction of the edge.
    const auto farthest = [&](const ScreenVertex& a, const ScreenVertex& b) {
        const auto way = [&](const ScreenVertex& v) {
            return absolute(v.x - ends.front().x) + absolute(v.y - ends.front().y);
        };
        return way(a) < way(b);
    };
    draw_line(pixel_at(ends.front(), part_), pixel_at(*std::max_element(ends.begin(), ends.end(), farthest), part_),
              {LineMethod::Bresenham, colour}, part_);
}

void Sketch::outline(std::span<const Vec3<World>> corners, std::uint8_t colour) {
    for (std::size_t i = 0; i < corners.size(); ++i) line(corners[i], corners[(i + 1) % corners.size()], colour);
}

void Sketch::polygon(std::span<const Vec3<World>> corners, std::uint8_t colour) {
    std::vector<ScreenVertex> screen = clipped(corners);
    if (screen.size() < 3) return;
    if (doubled_area(screen) < ScreenArea{}) std::reverse(screen.begin(), screen.end());
    ScanlineExtents rows(part_.height_px);
    scan_convex(screen, rows);
    for (std::int32_t y = rows.first; y < rows.end; ++y)
        if (item(rows.left, y) < item(rows.right, y))
            fill_area(part_, {item(rows.left, y), y, item(rows.right, y) - item(rows.left, y), 1}, colour);
}

void Sketch::axes(const std::array<Vec3<World>, 3>& ends, const GalleryAssets& assets) {
    const std::array<std::uint8_t, 3> colours{assets.colour(200, 80, 70), assets.colour(90, 170, 80),
                                              assets.colour(90, 130, 220)};
    constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
        line({}, ends[i], colours[i]);
        label(ends[i], kNames[i], colours[i]);
    }
}

void Sketch::label(const Vec3<World>& at, std::string_view text, std::uint8_t colour) {
    const std::optional<PlanePoint> place = place_of(at);
    if (!place) return;
    draw_text(part_, static_cast<std::int32_t>(place->x) + 3, static_cast<std::int32_t>(place->y) - 9, text,
              {colour, text_.dark});
}

std::optional<PlanePoint> Sketch::place_of(const Vec3<World>& point) const {
    const Vec4 corner = world_to_volume_ * homogeneous(point);
    if (volume_outcode(corner) != 0) return std::nullopt;
    const VolumeScreenPoint at = volume_to_screen(corner, part_.width_px, part_.height_px);
    return PlanePoint{number_of(at.x), number_of(at.y)};
}

Area scene_area(Framebuffer canvas, std::int32_t width_of_320) {
    return {0, kHeader_px, std::max(canvas.width_px * width_of_320 / 320, 8),
            std::max(canvas.height_px - kHeader_px - kFooter_px, 8)};
}

void draw_column(Framebuffer canvas, std::int32_t x, std::int32_t y, std::span<const std::string> lines,
                 TextColours colours) {
    const auto room = as_size(std::max(canvas.height_px - kFooter_px - y, 0) / kLineHeight_px);
    for (std::size_t i = 0; i < std::min(room, lines.size()); ++i) {
        const bool is_cut = i + 1 == room && room < lines.size();
        draw_text(canvas, x, y, is_cut ? "and " + std::to_string(lines.size() - i) + " more" : lines[i], colours);
        y += kLineHeight_px;
    }
}

void draw_note(Framebuffer canvas, std::span<const std::string> lines, TextColours colours) {
    if (canvas.width_px < 320) return;
    std::int32_t width_px = 0;
    for (const std::string& line : lines) width_px = std::max(width_px, text_width_px(line));
    fill_area(
        canvas,
        {0, kHeader_px, width_px + 2 * kTextMargin_px, static_cast<std::int32_t>(lines.size()) * kLineHeight_px + 5},
        colours.dark);
    draw_column(canvas, kTextMargin_px, kHeader_px + 3, lines, colours);
}

PlanePoint shown(const Vec& place, const ViewContext& view) {
    const ScreenPosition position = project(to_view(world_point(place), view), view.projection);
    return {number_of(position.x), number_of(position.y)};
}

double across(const Vec& from, const Vec& to, const ViewContext& view) {
    return std::abs(shown(to, view).x - shown(from, view).x);
}

WireScene::WireScene(const RowInput& input, const ViewSpec& spec, Framebuffer canvas)
    : assets_(input.assets),
      canvas_(canvas),
      rows_(canvas.height_px),
      view_(make_view_context(spec, input.mode, {30, View::kFractionBits, 8, input.settings.correct_aspect})) {}

void WireScene::fill_background() {
    fill(canvas_, assets_.colour(20, 24, 36));
}
void WireScene::line(const Vec& from, const Vec& to, std::uint8_t colour) {
    const PlanePoint a = shown(from, view_), b = shown(to, view_);
    line(a, b, colour);
}
void WireScene::line(const PlanePoint& from, const PlanePoint& to, std::uint8_t colour) {
    const auto pixel = [](const PlanePoint& at) {
        return PixelPosition{static_cast<std::int32_t>(std::floor(at.x)), static_cast<std::int32_t>(std::floor(at.y))};
    };
    draw_line(pixel(from), pixel(to), {LineMethod::Bresenham, colour}, canvas_);
}
bool WireScene::polygon(std::span<const Vec> corners, std::uint8_t colour) {
    std::vector<Vec3<World>> world;
    for (const Vec& corner : corners) world.push_back(world_point(corner));
    if (!project_polygon(world, view_, polygon_) || doubled_area(polygon_.vertices) <= ScreenArea{}) return false;
    scan_convex(polygon_.vertices, rows_);
    for (std::int32_t y = rows_.first; y < rows_.end; ++y)
        for (std::int32_t x = std::max(item(rows_.left, y), 0); x < item(rows_.right, y); ++x)
            set_pixel(canvas_, x, y, colour);
    return true;
}
void WireScene::circle(const Vec& middle, const Vec& one, const Vec& other, std::uint8_t colour) {
    constexpr int kParts = 48;
    const auto on_it = [&](int part) {
        const double angle = part * 2 * std::numbers::pi / kParts, c = std::cos(angle), s = std::sin(angle);
        return middle + one * c + other * s;
    };
    for (int part = 0; part < kParts; ++part) line(on_it(part), on_it(part + 1), colour);
}
void WireScene::label(const Vec& place, std::string_view text) {
    const PlanePoint pixel = shown(place, view_);
    draw_text(canvas_, static_cast<std::int32_t>(pixel.x) + 2, static_cast<std::int32_t>(pixel.y) - 4, text,
              assets_.text);
}

void draw_cube(const Cube& cube, const GalleryAssets& assets, WireScene& scene) {
    const std::array<std::uint8_t, 3> colours{assets.colour(96, 112, 140), assets.colour(64, 76, 104),
                                              assets.colour(46, 54, 78)};
    std::array<bool, 6> is_front{};
    for (std::size_t face = 0; face < 6; ++face) {
        std::array<Vec, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) corners[i] = cube.corner(kCubeFaces[face][i]);
        is_front[face] = scene.polygon(corners, colours[face % 3]);
        const Vec one = (corners[1] - corners[0]) * 0.5, other = (corners[3] - corners[0]) * 0.5;
        if (is_front[face]) scene.circle(corners[0] + one + other, one, other, assets.colour(220, 150, 60));
    }
    for (const bool front : {false, true})
        for (std::size_t face = 0; face < 6; ++face)
            for (std::size_t i = 0; i < 4 && is_front[face] == front; ++i)
                scene.line(cube.corner(kCubeFaces[face][i]), cube.corner(kCubeFaces[face][(i + 1) % 4]),
                           front ? assets.colour(230, 230, 240) : assets.colour(90, 96, 120));
}

void draw_axes(const Vec& origin, double length, const GalleryAssets& assets, WireScene& scene) {
    const std::array<Vec, 3> ends{{{origin.x + length, origin.y, origin.z},
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

Vec3<World> middle_of_demo_level() {
    return world_point(300, 800, 40);
}

Camera camera_at(std::int32_t x, std::int32_t y, std::int32_t z, int yaw, int pitch, int field_of_view) {
    return {{World::from_int(x), World::from_int(y), World::from_int(z)},
            degrees_to_angle(Degrees::from_int(yaw)),
            degrees_to_angle(Degrees::from_int(pitch)),
            {},
            Degrees::from_int(field_of_view)};
}

void enlarge(std::span<const std::uint8_t> pixels, const ScreenMode& mode, Framebuffer canvas) {
    paint(canvas, [&](std::int32_t x, std::int32_t y) {
        return item(pixels,
                    y * mode.height_px / canvas.height_px * mode.width_px + x * mode.width_px / canvas.width_px);
    });
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
