// Seed 3 (Notes): pictures on surfaces, in 256 colours.
// Seeds 3 and 5: a model in the pipeline, and among the surfaces of a level.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/base/table.h"
#include "engine/draw/drawing.h"
#include "engine/files/picture.h"
#include "engine/fixed/trig.h"
#include "tools/gallery/mesh_scene.h"
#include "tools/gallery/row.h"
#include "tools/gallery/sketch.h"

namespace oblong {
namespace {

constexpr ColourRange kGreys{0, 16};  ///< of the demo level's palette

/// Red, green and blue.
Vec channels_of(Rgb8 colour) {
    return {static_cast<double>(colour.red), static_cast<double>(colour.green), static_cast<double>(colour.blue)};
}

/// A picture of a ball before an evening sky, from the top left corner, (0, 0), to the bottom right one, (wide, 1).
Vec colour_at(double x, double y, double wide) {
    const double right = (x - wide / 2) / 0.34, down = (y - 0.52) / 0.34, square = right * right + down * down;
    const auto mixed = [](const Vec& from, const Vec& to, double part) { return from + (to - from) * part; };
    if (square >= 1) return mixed({18, 26, 74}, {226, 142, 84}, y * y);
    const double towards_light = (-0.5 * right - 0.6 * down + 0.62 * std::sqrt(1 - square));
    return mixed({34, 20, 40}, {240, 214, 176}, std::max(towards_light, 0.0));
}

std::uint8_t whole(double channel) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(channel, 0.0, 255.0)));
}

PngImage make_picture(const Area& area, Ratio pixel, bool is_grey) {
    const double shape = number_of(pixel);
    const double wide = area.width * shape / area.height;
    PngImage image{area.width, area.height, {}, {}};
    for (std::int32_t y = 0; y < area.height; ++y)
        for (std::int32_t x = 0; x < area.width; ++x) {
            const Vec c = colour_at((x + 0.5) * shape / area.height, (y + 0.5) / area.height, wide);
            const Rgb8 colour{whole(c.x), whole(c.y), whole(c.z)};
            const std::uint8_t grey = whole(luminance_1000(colour) / 1000.0);
            image.colours.push_back({is_grey ? Rgb8{grey, grey, grey} : colour});
        }
    return image;
}

/// The error of the means of 8x8 blocks, averaged over blocks and channels.
double block_error(const PngImage& image, const std::vector<std::uint8_t>& indices, const Palette& palette) {
    constexpr std::int32_t kBlock = 8;
    double sum = 0;
    int count = 0;
    for (std::int32_t top = 0; top + kBlock <= image.height_px; top += kBlock)
        for (std::int32_t left = 0; left + kBlock <= image.width_px; left += kBlock) {
            Vec off;
            for (std::int32_t i = 0; i < kBlock * kBlock; ++i) {
                const std::int32_t place = (top + i / kBlock) * image.width_px + left + i % kBlock;
                off = off + (channels_of(item(palette.colours, item(indices, place))) -
                             channels_of(item(image.colours, place).colour));
            }
            sum += (std::abs(off.x) + std::abs(off.y) + std::abs(off.z)) / (kBlock * kBlock);
            count += 3;
        }
    return sum / count;
}

/// The same picture with the nearest colours and dithered, side by side.
Figures draw_quantisation(const RowInput& input, Framebuffer canvas) {
    const Palette& palette = input.assets.colormap.palette;
    const bool is_grey = input.values[0] == 1;
    const ColourRange range = is_grey ? kGreys : kOrdinaryColours;
    fill(canvas, input.assets.colour(20, 24, 36));
    const std::int32_t width = canvas.width_px / 2 - 6, top = kHeader_px + 4;
    const Area left{4, top, width, canvas.height_px - kFooter_px - top - 14};
    const PngImage image = make_picture(left, input.mode.pixel(), is_grey);
    std::array<double, 2> errors{};
    for (const Dither dither : {Dither::None, Dither::FloydSteinberg}) {
        const bool is_right = dither == Dither::FloydSteinberg;
        const std::int32_t x = is_right ? canvas.width_px - 4 - width : left.x;
        const std::vector<std::uint8_t> indices = indices_of(image, palette, range, dither);
        for (std::int32_t i = 0; i < image.width_px * image.height_px; ++i)
            set_pixel(canvas, x + i % width, top + i / width, item(indices, i));
        errors[is_right] = block_error(image, indices, palette);
        draw_text(canvas, x, top + left.height + 4, is_right ? "Floyd-Steinberg" : "nearest colour", input.assets.text);
    }
    const double nearest = errors[0], dithered = errors[1];
    return {{"mean error, dithered", "below half of " + decimal_text(nearest, "%.2f"), decimal_text(dithered, "%.2f"),
             dithered < nearest / 2},
            measured("mean error, nearest colours", decimal_text(nearest, "%.2f"))};
}

MeshLight light_from_above() {
    return {50, {unit_vector(-1, -1, 2), 90}, {}, 100};
}

constexpr double kHalfCube = 30;
constexpr int kPitchDegrees = 25;

/// The number of sides of a turned cube that face the eye, which is `distance` from its middle.
std::int64_t sides_in_front(double distance, double yaw, double pitch) {
    // The x components of its axes: ahead, left, up.
    const std::array towards{std::cos(pitch) * std::cos(yaw), -std::sin(yaw), std::sin(pitch) * std::cos(yaw)};
    return std::count_if(towards.begin(), towards.end(),
                         [distance](double x) { return distance * std::abs(x) > kHalfCube; });
}

Figures draw_cube(const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    fill(canvas, assets.colour(20, 24, 36));
    const Mesh cube =
        cube_mesh(kHalfCube, checkered_skin(64, lit_colour(assets, 190, 150, 90), lit_colour(assets, 120, 60, 40)));
    PlacedMesh placed;
    placed.mesh = &cube;
    placed.shading = Shading::Flat;
    placed.position = world_point(input.number(1), 0, 0);
    placed.yaw = input.angle(0);
    placed.pitch = degrees_to_angle(Degrees::from_int(-kPitchDegrees));
    std::vector<std::uint8_t> covered(pixel_count(canvas.width_px, canvas.height_px), 255);
    MeshScene scene(input, canvas),
        counted(input, {covered.data(), canvas.width_px, canvas.height_px, canvas.width_px});
    scene.draw(placed, light_from_above());
    const Colormap numbers = shade_numbers();
    const MeshCounts counts = counted.draw(placed, light_from_above(), &numbers);
    const std::int64_t sides =
        sides_in_front(input.number(1), input.radians(0), -kPitchDegrees * std::numbers::pi / 180);
    return {count_figure("triangles that face the eye, of 12", 2 * sides, counts.facing),
            count_figure("pixels drawn: each once",
                         std::ssize(covered) - std::count(covered.begin(), covered.end(), 255), counts.pixels),
            measured("triangles with pixels, after clipping to the view", counts.triangles)};
}

Figures draw_in_level(const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    const Mesh ball =
        ball_mesh(30, 16, checkered_skin(64, lit_colour(assets, 200, 190, 170), lit_colour(assets, 60, 80, 130)));
    PlacedMesh placed;
    placed.mesh = &ball;
    placed.shading = static_cast<Shading>(input.values[1]);
    placed.highlight = 60;
    placed.position = world_point(input.number(0), 420, 60);
    placed.yaw = Angle::from_bam(input.time_ms * 8);
    DemoFrame frame(input, input.mode);
    FrameCounts counts;
    frame.work.observers.counts = &counts;
    const Camera camera = camera_at(0, 120, 70, 90, 0, 70);
    std::vector<std::uint8_t> without(pixel_count(canvas.width_px, canvas.height_px));
    frame.draw(camera, {without.data(), canvas.width_px, canvas.height_px, canvas.width_px});
    const auto wanted = [&frame] {
        std::int64_t pixels = 0;
        for (const ScreenRectangle& part : frame.work.view.depth.rectangles())
            pixels += std::int64_t{part.end_column - part.first_column} * (part.end_row - part.first_row);
        return pixels;
    };
    const std::int64_t before = wanted();
    frame.scene.meshes = {&placed, 1};
    frame.draw(camera, canvas);
    return {count_figure("pixels with depth in a frame without it", 0, before),
            measured("pixels with depth: the rectangle around it", wanted()),
            measured("pixels that it owns", counts.of(Effect::Meshes))};
}

}  // namespace

std::vector<Row> texture_rows() {
    return {{"texture-quantise", draw_quantisation, {choice_parameter("palette", {"224 colours", "16 greys"})}}};
}

std::vector<Row> mesh_rows() {
    return {{"mesh-pipeline", draw_cube, {{"turn, degrees", 0, 355, 5, 30}, {"distance", 32, 400, 8, 160}}},
            {"mesh-in-level",
             draw_in_level,
             {{"x", -200, 200, 10, -70}, choice_parameter("shading", {"flat", "Gouraud", "Phong"}, 1)}}};
}

}  // namespace oblong
