// Hidden surfaces: the same views by each method (seeds 3 and 4), their intermediate results, and where one fails.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/accuracy/accuracy.h"
#include "engine/base/table.h"
#include "engine/draw/drawing.h"
#include "engine/fixed/arithmetic.h"
#include "engine/level/side.h"
#include "engine/methods/hidden_surfaces.h"
#include "tools/gallery/row.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

/// A view down the demo level's hall over lava, where large faces lie behind one another.
Camera camera_in_hall() {
    return camera_at(-440, 2320, 100, 0, 6);
}

/// A frame of the demo level by one method, with its intermediate results.
class MethodFrame {
  public:
    MethodFrame(const RowInput& input, HiddenSurfaces method, const ScreenMode& mode)
        : pixels(pixel_count(mode.width_px, mode.height_px)), by(method), frame_(input, mode) {
        frame_.work.observers.counts = &counted;
        frame_.work.claimer = &by;
        frame_.draw(camera_in_hall(), {pixels.data(), mode.width_px, mode.height_px, mode.width_px});
    }

    const HiddenSurfaceCounts& counts() const { return by.counts(); }
    const PixelOwners& owners() const { return by.owners(); }
    const ScannedFaces& scanned() const { return by.scanned(); }

    std::vector<std::uint8_t> pixels;
    HiddenSurfaceMethod by;
    FrameCounts counted;

  private:
    DemoFrame frame_;
};

Parameter method_parameter(HiddenSurfaces start) {
    return choice_parameter("method", {kHiddenSurfaceNames.begin(), kHiddenSurfaceNames.end()},
                            static_cast<std::int64_t>(start));
}

std::string per_pixel(std::int64_t count, std::size_t pixels) {
    return decimal_text(static_cast<double>(count) / static_cast<double>(pixels), "%.2f");
}

/// Copies a picture; pixels that differ from `right` become `warning` if it is set. Returns the number of differences.
std::int64_t show_differences(std::span<const std::uint8_t> shown, std::span<const std::uint8_t> right,
                              std::optional<std::uint8_t> warning, Framebuffer canvas) {
    std::int64_t differences = 0;
    paint(canvas, [&](std::int32_t x, std::int32_t y) {
        const auto pixel = as_size(y * canvas.width_px + x);
        const bool differs = shown[pixel] != right[pixel];
        differences += differs;
        return differs && warning && (x + y) % 2 == 0 ? *warning : shown[pixel];
    });
    return differences;
}

/// A count of wrong pixels: none is expected of an exact picture.
Figure wrong_pixels(std::string name, std::int64_t wrong, bool is_exact) {
    return is_exact ? count_figure(std::move(name), 0, wrong) : measured(std::move(name), wrong);
}

/// Whether a method is exact with these settings. With coarsely rounded 1/z and corners, the z-buffer's depths and the
/// rays' exact outlines may differ from the span buffer's picture.
bool is_exact(HiddenSurfaces method, const Accuracy& accuracy) {
    if (method == HiddenSurfaces::SpanBuffer || method == HiddenSurfaces::Painter) return true;
    const Accuracy finest = accuracy_of(Preset::Exact);
    return method == HiddenSurfaces::ZBuffer && accuracy.subpixel_bits == finest.subpixel_bits &&
           accuracy.inverse_z_bits == finest.inverse_z_bits;
}

/// The pixels that two methods give to faces which are not equally deep there within 1/256 pixel, the rounding of their
/// corners.
std::int64_t count_unlike(const MethodFrame& a, const MethodFrame& b) {
    std::int64_t count = 0;
    const std::int32_t width_px = a.owners().width_px;
    for (std::size_t pixel = 0; pixel < a.owners().faces.size(); ++pixel) {
        const std::int32_t one = a.owners().faces[pixel], other = b.owners().faces[pixel];
        if (one == other) continue;
        if (one < 0 || other < 0) {
            ++count;
            continue;
        }
        const ScannedFace &f = item(a.scanned().faces, one), &g = item(a.scanned().faces, other);
        // Seen from behind, it covers a pixel only since its corners are rounded.
        if (std::min(f.eye_distance, g.eye_distance) <= PlaneDistance{}) continue;
        const auto &p = f.inverse_z, &q = g.inverse_z;
        const auto column = static_cast<std::int32_t>(pixel) % width_px,
                   row = static_cast<std::int32_t>(pixel) / width_px;
        const auto apart = [](InverseZ from, InverseZ to) { return std::abs(number_of(from) - number_of(to)); };
        count += apart(p.at(column, row), q.at(column, row)) * 256 >
                 apart(p.per_column, q.per_column) + apart(p.per_row, q.per_row);
    }
    return count;
}

Figures draw_hidden_surface_methods(const RowInput& input, Framebuffer canvas) {
    const auto method = static_cast<HiddenSurfaces>(input.values[0]);
    const MethodFrame frame(input, method, input.mode), right(input, HiddenSurfaces::SpanBuffer, input.mode);
    const auto warning = input.values[1] == 1 ? std::optional(input.assets.colour(90, 255, 90)) : std::nullopt;
    const std::int64_t wrong = show_differences(frame.pixels, right.pixels, warning, canvas);
    const HiddenSurfaceCounts& counts = frame.counts();
    const std::size_t pixels = frame.pixels.size();
    Figures figures{wrong_pixels("pixels unlike the span buffer's", wrong,
                                 method != HiddenSurfaces::ZBuffer && is_exact(method, input.settings.accuracy))};
    if (method == HiddenSurfaces::ZBuffer)
        figures.push_back(wrong_pixels("of them not equally deep",
                                       count_unlike(frame, MethodFrame(input, HiddenSurfaces::Painter, input.mode)),
                                       is_exact(method, input.settings.accuracy)));
    if (method == HiddenSurfaces::SpanBuffer) {
        figures.push_back(measured("rows of faces looked up", frame.counted.stages.claimed_rows));
        figures.push_back(measured("faces scanned", frame.counted.faces_visited));
    } else if (method == HiddenSurfaces::RayCasting) {
        figures.push_back(measured("rays held against faces", counts.ray_face_tests));
        figures.push_back(measured("faces for each ray", counts.faces_scanned));
    } else {
        figures.push_back(measured("writes for each pixel", per_pixel(counts.pixels_written, pixels)));
        figures.push_back(measured("depths compared for each pixel", per_pixel(counts.pixels_tested, pixels)));
        figures.push_back(measured("faces compared to sort them", counts.order_comparisons));
    }
    return figures;
}

/// Colours for counts 0, 1, 2, ...; the last one is for all higher counts.
std::vector<std::uint8_t> heat_colours(const GalleryAssets& assets) {
    return {assets.colour(10, 12, 20),   assets.colour(24, 44, 96),   assets.colour(30, 90, 140),
            assets.colour(40, 140, 110), assets.colour(120, 170, 60), assets.colour(220, 190, 60),
            assets.colour(240, 130, 40), assets.colour(230, 60, 40),  assets.colour(250, 240, 230)};
}

void draw_legend(std::span<const std::uint8_t> colours, const GalleryAssets& assets, Framebuffer canvas) {
    constexpr std::int32_t kWidth_px = 14, kHeight_px = 10;
    const std::int32_t top = canvas.height_px - kFooter_px - kHeight_px - 3;
    for (std::size_t i = 1; i < colours.size(); ++i) {
        const std::int32_t left = kTextMargin_px + static_cast<std::int32_t>(i - 1) * (kWidth_px + 1);
        fill_area(canvas, {left, top, kWidth_px, kHeight_px}, colours[i]);
        const std::string label = std::to_string(i) + (i + 1 == colours.size() ? "+" : "");
        draw_text(canvas, left + 2, top + 1, label, assets.text);
    }
}

Figures draw_overdraw(const RowInput& input, Framebuffer canvas) {
    const bool is_painter = input.values[0] == 0;
    const MethodFrame frame(input, is_painter ? HiddenSurfaces::Painter : HiddenSurfaces::SpanBuffer, input.mode);
    std::vector<std::int64_t> writes(frame.counted.writes.begin(), frame.counted.writes.end());
    if (is_painter) {
        std::fill(writes.begin(), writes.end(), 0);
        for (const Span& span : frame.scanned().spans)
            for (std::int32_t x = span.first; x < span.end; ++x) ++item(writes, span.y * canvas.width_px + x);
    }
    const std::vector<std::uint8_t> colours = heat_colours(input.assets);
    paint(canvas, [&](std::int32_t x, std::int32_t y) {
        const std::int64_t count = item(writes, y * canvas.width_px + x);
        return item(colours, std::min<std::int64_t>(count, std::ssize(colours) - 1));
    });
    draw_legend(colours, input.assets, canvas);
    const std::int64_t sum = std::accumulate(writes.begin(), writes.end(), std::int64_t{0});
    const std::int64_t expected =
        is_painter ? frame.counts().pixels_written : std::int64_t{canvas.width_px} * canvas.height_px;
    return {count_figure(is_painter ? "pixels that the painter wrote" : "pixels written, each once", expected, sum),
            measured("writes for each pixel", per_pixel(sum, writes.size())),
            measured("most at one pixel", *std::max_element(writes.begin(), writes.end()))};
}

/// A grey for a depth: equal steps in log z, near is bright.
std::uint8_t depth_colour(InverseZ inverse_z, std::span<const std::uint8_t> greys) {
    const double z = 1 / number_of(std::max(inverse_z, InverseZ::ulp()));
    const double share = std::clamp((std::log2(1200.0) - std::log2(std::max(z, 1.0))) / 4.5, 0.0, 1.0);
    return item(greys, share * static_cast<double>(greys.size() - 1));
}

std::vector<std::uint8_t> depth_greys(const GalleryAssets& assets) {
    std::vector<std::uint8_t> greys;
    for (int i = 0; i < 48; ++i) greys.push_back(assets.colour(12 + i * 4, 16 + i * 4, 28 + i * 7 / 2));
    return greys;
}

/// A pixel whose depth is checked; it shows a wall.
struct Pixel {
    std::int32_t column, row;
};

/// z of the surface at a pixel, from the tree alone: where the line of sight enters solid space.
double depth_by_tree(const Level& level, const Camera& camera, const ScreenMode& mode, Pixel pixel) {
    const Basis axes = view_basis(camera.yaw, camera.pitch, camera.roll);
    const ViewDirections directions = make_view_directions(axes, make_projection(mode, camera.field_of_view));
    const auto is_open = [&](double z) {
        const auto moved = [&](World from, const LinearQuantity<DirectionPart>& direction) {
            const double step = number_of(direction.at(pixel.column, pixel.row));
            return from + fixed_of<World>(step * z);
        };
        const Vec3<World> place{moved(camera.eye.x, directions.x), moved(camera.eye.y, directions.y),
                                moved(camera.eye.z, directions.z)};
        return level.leaves[find_leaf(level, level.world(), place)].contents != contents::kSolid;
    };
    double open = 0, solid = 1;
    for (; is_open(solid); ++solid) open = solid;
    while (solid - open > 1e-3) (is_open((open + solid) / 2) ? open : solid) = (open + solid) / 2;
    return open;
}

Figures draw_depth(const RowInput& input, Framebuffer canvas) {
    RowInput rounded = input;
    rounded.settings.accuracy.inverse_z_bits = static_cast<std::int32_t>(input.values[0]);
    const MethodFrame frame(rounded, HiddenSurfaces::ZBuffer, input.mode),
        right(input, HiddenSurfaces::Painter, input.mode);
    const std::vector<std::uint8_t> greys = depth_greys(input.assets);
    const std::uint8_t warning = input.assets.colour(90, 255, 90);
    std::int64_t wrong = 0;
    paint(canvas, [&](std::int32_t x, std::int32_t y) {
        const auto pixel = as_size(y * canvas.width_px + x);
        const bool differs = frame.owners().faces[pixel] != right.owners().faces[pixel];
        wrong += differs;
        return differs ? warning : depth_colour(frame.by.depths()[pixel], greys);
    });
    const Pixel checked{canvas.width_px / 8, canvas.height_px / 4};
    const InverseZ inverse_z = item(frame.by.depths(), checked.row * canvas.width_px + checked.column);
    const double z = 1 / number_of(inverse_z);
    const double by_tree = depth_by_tree(input.assets.demo_level, camera_in_hall(), input.mode, checked);
    const bool is_finest = is_exact(HiddenSurfaces::ZBuffer, rounded.settings.accuracy);
    return {measured("pixels that go to another face than by the tree", wrong),
            wrong_pixels("of them not equally deep", count_unlike(frame, right), is_finest),
            is_finest ? number_figure("z on the left wall, units", by_tree, z, 0.01, 2)
                      : measured("z on the left wall, units", decimal_text(z, "%.2f")),
            measured("pixels written and then hidden", frame.counts().pixels_written - std::ssize(frame.pixels))};
}

/// From near to far.
std::vector<std::uint8_t> order_colours(const GalleryAssets& assets) {
    std::vector<std::uint8_t> colours;
    constexpr int kSteps = 40;
    for (int i = 0; i < kSteps; ++i) {
        const double share = static_cast<double>(i) / (kSteps - 1), turn = share * 4.2;
        const auto part = [&](double phase) {
            return static_cast<int>(70 + 150 * (0.5 + 0.5 * std::cos(turn - phase)) * (1 - share * 0.5));
        };
        colours.push_back(assets.colour(part(0), part(1.6), part(3.6)));
    }
    return colours;
}

bool owns_pixel(const PixelOwners& owners, std::int32_t face) {
    return std::find(owners.faces.begin(), owners.faces.end(), face) != owners.faces.end();
}

Figures draw_tree_order(const RowInput& input, Framebuffer canvas) {
    const MethodFrame frame(input, HiddenSurfaces::Painter, input.mode),
        depths(input, HiddenSurfaces::ZBuffer, input.mode);
    const ScannedFaces& scanned = frame.scanned();
    const std::vector<std::uint8_t> colours = order_colours(input.assets);
    fill(canvas, input.assets.colour(14, 16, 24));
    std::vector<std::int32_t> order = back_to_front_by_tree(scanned);
    std::erase_if(order, [&](std::int32_t face) { return !owns_pixel(frame.owners(), face); });
    const auto painted = as_size(input.values[0]) * order.size() / 16;
    for (std::size_t place = 0; place < painted; ++place) {
        const std::uint8_t colour = colours[(order.size() - 1 - place) * colours.size() / order.size()];
        for (const Span& span : scanned.spans_of(item(scanned.faces, order[place]))) {
            std::fill(canvas.row(span.y) + span.first, canvas.row(span.y) + span.end, colour);
            set_pixel(canvas, span.first, span.y, input.assets.colour(14, 16, 24));
        }
    }
    return {wrong_pixels("pixels whose last face is not the nearest", count_unlike(frame, depths),
                         is_exact(HiddenSurfaces::ZBuffer, input.settings.accuracy)),
            measured("faces painted", static_cast<std::int64_t>(painted)),
            measured("of", static_cast<std::int64_t>(order.size()))};
}

Figures draw_rays(const RowInput& input, Framebuffer canvas) {
    const auto step = static_cast<std::int32_t>(input.values[0]);
    const ScreenMode mode{std::max(input.mode.width_px / step, 16), std::max(input.mode.height_px / step, 10),
                          input.mode.display};
    const MethodFrame frame(input, HiddenSurfaces::RayCasting, mode), right(input, HiddenSurfaces::SpanBuffer, mode);
    const std::int64_t differences = count_differences(frame.pixels, right.pixels);
    enlarge(frame.pixels, mode, canvas);
    const std::int64_t rays = std::int64_t{mode.width_px} * mode.height_px;
    return {count_figure("rays x faces", rays * std::ssize(frame.by.targets().opaque), frame.counts().ray_face_tests),
            measured("rays", rays), measured("pixels unlike the span buffer's", differences)};
}

}  // namespace

std::vector<Row> hidden_surface_rows() {
    return {{"hidden-surfaces",
             draw_hidden_surface_methods,
             {method_parameter(HiddenSurfaces::PainterSorted),
              choice_parameter("differences", {"not marked", "marked"}, 1)}},
            {"overdraw", draw_overdraw, {choice_parameter("method", {"painter", "span buffer"})}},
            {"z-buffer", draw_depth, {{"fraction bits of 1/z", 12, 44, 1, 44}}},
            {"tree-order", draw_tree_order, {{"sixteenths of the faces painted", 1, 16, 1, 16}}},
            {"ray-casting", draw_rays, {{"a ray every ... pixels", 2, 20, 1, 2}}}};
}

}  // namespace oblong
