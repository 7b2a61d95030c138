#include "tools/gallery/cube_scene.h"

#include <array>
#include <cmath>
#include <numbers>

#include "engine/draw/drawing.h"
#include "engine/fixed/trig.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/raster/lines.h"
#include "engine/view/project.h"
#include "tools/gallery/row.h"

namespace oblong {

namespace {

/// Clockwise seen from outside: top, south, east, and the three opposite.
constexpr std::array<std::array<int, 4>, 6> kCubeFaces{
    {{4, 6, 7, 5}, {0, 4, 5, 1}, {1, 5, 7, 3}, {0, 1, 3, 2}, {3, 7, 6, 2}, {2, 6, 4, 0}}};

Place half_of(const Place& from, const Place& to) {
    return {(to.x - from.x) / 2, (to.y - from.y) / 2, (to.z - from.z) / 2};
}

}  // namespace

Vec3<World> in_world(const Place& place) {
    return world_point(place.x, place.y, place.z);
}

PixelPlace shown(const Place& place, const ViewContext& view) {
    const ScreenPosition position = project(to_view(in_world(place), view), view.projection);
    return {std::ldexp(position.x.raw, -8), std::ldexp(position.y.raw, -8)};
}

double across(const Place& from, const Place& to, const ViewContext& view) {
    return std::abs(shown(to, view).x - shown(from, view).x);
}

WireScene::WireScene(const RowInput& input, const ViewSpec& spec, Framebuffer canvas)
    : assets_(input.assets),
      canvas_(canvas),
      rows_(canvas.height_px),
      view_(make_view_context(spec, input.mode, {30, View::kFractionBits, 8, input.settings.correct_aspect})) {}

void WireScene::fill_background() {
    fill_area(canvas_, {0, 0, canvas_.width_px, canvas_.height_px}, assets_.colour(20, 24, 36));
}
void WireScene::line(const Place& from, const Place& to, std::uint8_t colour) {
    const PixelPlace a = shown(from, view_), b = shown(to, view_);
    line(a, b, colour);
}
void WireScene::line(const PixelPlace& from, const PixelPlace& to, std::uint8_t colour) {
    const auto pixel = [](const PixelPlace& at) {
        return PixelPosition{static_cast<std::int32_t>(std::floor(at.x)), static_cast<std::int32_t>(std::floor(at.y))};
    };
    draw_line(pixel(from), pixel(to), {LineMethod::Bresenham, colour}, canvas_);
}
bool WireScene::polygon(std::span<const Place> corners, std::uint8_t colour) {
    std::vector<Vec3<World>> world;
    for (const Place& corner : corners) world.push_back(in_world(corner));
    if (!project_polygon(world, view_, polygon_) || doubled_area(polygon_.screen) <= ScreenArea{}) return false;
    scan_convex(polygon_.screen, rows_);
    for (std::int32_t y = rows_.first; y < rows_.end; ++y)
        for (std::int32_t x = std::max(at(rows_.left, y), 0); x < at(rows_.right, y); ++x)
            set_pixel(canvas_, x, y, colour);
    return true;
}
void WireScene::circle(const Place& middle, const Place& one, const Place& other, std::uint8_t colour) {
    constexpr int kParts = 48;
    const auto on_it = [&](int part) {
        const double angle = part * 2 * std::numbers::pi / kParts, c = std::cos(angle), s = std::sin(angle);
        return Place{middle.x + c * one.x + s * other.x, middle.y + c * one.y + s * other.y,
                     middle.z + c * one.z + s * other.z};
    };
    for (int part = 0; part < kParts; ++part) line(on_it(part), on_it(part + 1), colour);
}
void WireScene::label(const Place& place, std::string_view text) {
    const PixelPlace pixel = shown(place, view_);
    draw_text(canvas_, static_cast<std::int32_t>(pixel.x) + 2, static_cast<std::int32_t>(pixel.y) - 4, text,
              assets_.text);
}

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

void draw_demo_level(const RowInput& input, const ViewSpec& view, Framebuffer canvas) {
    const Level& level = input.assets.demo_level;
    const std::vector<PlacedModel> models = models_at_rest(level);
    FrameWorkspace work(level, input.mode);
    draw_frame({level, input.assets.colormap, models, input.time_ms}, view, input.mode, input.settings, work, canvas);
}

void draw_demo_level(const RowInput& input, const Camera& camera, const ScreenMode& mode, Framebuffer canvas) {
    const Level& level = input.assets.demo_level;
    const std::vector<PlacedModel> models = models_at_rest(level);
    FrameWorkspace work(level, mode);
    draw_frame({level, input.assets.colormap, models, input.time_ms}, camera, mode, input.settings, work, canvas);
}

}  // namespace oblong
