// Hidden surfaces: the same views by each method (seeds 3 and 4), their intermediate results, and where one fails.

#include "engine/level/side.h"
#include "engine/methods/hidden_surfaces.h"
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
    MethodFrame(const RowInput& input, HiddenSurfaces method) : MethodFrame(input, method, input.mode) {}
    MethodFrame(const RowInput& input, HiddenSurfaces method, const ScreenMode& mode)
        : picture(mode.width_px, mode.height_px), by(method), frame_(input, mode) {
        frame_.work.observers.counts = &counted;
        frame_.work.claimer = &by;
        frame_.draw(camera_in_hall(), picture);
    }

    const HiddenSurfaceCounts& counts() const { return by.counts(); }
    const PixelOwners& owners() const { return by.owners(); }
    const ScannedFaces& scanned() const { return by.scanned(); }
    /// A count for each pixel.
    Figure per_pixel(std::string name, std::int64_t count) const {
        const auto pixels = static_cast<double>(picture.indices.size());
        return {std::move(name), decimal_text(static_cast<double>(count) / pixels, "%.2f")};
    }

    SidePicture picture;
    HiddenSurfaceMethod by;
    FrameCounts counted;

  private:
    DemoFrame frame_;
};

/// A count of wrong pixels: none is expected of an exact picture.
Figure wrong_pixels(std::string name, std::int64_t wrong, bool is_exact) {
    return is_exact ? Figure{std::move(name), 0, wrong} : Figure{std::move(name), wrong};
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

Figures draw_hidden_surface_methods(const RowInput& input, Canvas& canvas) {
    const auto method = static_cast<HiddenSurfaces>(input.values[0]);
    const MethodFrame frame(input, method), right(input, HiddenSurfaces::SpanBuffer);
    const bool is_marked = input.values[1] == 1, exact = is_exact(method, input.settings.accuracy);
    const std::uint8_t warning = input.colour(kGreen);
    canvas.paint([&](std::int32_t x, std::int32_t y) {
        const std::uint8_t shown = frame.picture.row(y)[x];
        return is_marked && shown != right.picture.row(y)[x] && (x + y) % 2 == 0 ? warning : shown;
    });
    const HiddenSurfaceCounts& counts = frame.counts();
    Figures figures{wrong_pixels("pixels unlike the span buffer's",
                                 count_differences(frame.picture.indices, right.picture.indices),
                                 method != HiddenSurfaces::ZBuffer && exact)};
    const auto add = [&figures](const Figures& more) { figures.insert(figures.end(), more.begin(), more.end()); };
    if (method == HiddenSurfaces::ZBuffer)
        add({wrong_pixels("of them not equally deep", count_unlike(frame, {input, HiddenSurfaces::Painter}), exact)});
    if (method == HiddenSurfaces::SpanBuffer)
        add({{"rows of faces looked up", frame.counted.stages.claimed_rows},
             {"faces scanned", frame.counted.faces_visited}});
    else if (method == HiddenSurfaces::RayCasting)
        add({{"rays held against faces", counts.ray_face_tests}, {"faces for each ray", counts.faces_scanned}});
    else
        add({frame.per_pixel("writes for each pixel", counts.pixels_written),
             frame.per_pixel("depths compared for each pixel", counts.pixels_tested),
             {"faces compared to sort them", counts.order_comparisons}});
    return figures;
}

/// Colours for counts 0, 1, 2, ...; the last one is for all higher counts.
constexpr std::array kHeat{Rgb8{10, 12, 20},   Rgb8{24, 44, 96},   Rgb8{30, 90, 140},
                           Rgb8{40, 140, 110}, Rgb8{120, 170, 60}, Rgb8{220, 190, 60},
                           Rgb8{240, 130, 40}, Rgb8{230, 60, 40},  Rgb8{250, 240, 230}};

Figures draw_overdraw(const RowInput& input, Canvas& canvas) {
    const bool is_painter = input.values[0] == 0;
    const MethodFrame frame(input, is_painter ? HiddenSurfaces::Painter : HiddenSurfaces::SpanBuffer);
    std::vector<std::int64_t> writes(frame.counted.writes.begin(), frame.counted.writes.end());
    if (is_painter) {
        std::fill(writes.begin(), writes.end(), 0);
        for (const Span& span : frame.scanned().spans)
            for (std::int32_t x = span.first; x < span.end; ++x) ++item(writes, span.y * canvas.width_px + x);
    }
    std::array<std::uint8_t, kHeat.size()> heat;
    std::transform(kHeat.begin(), kHeat.end(), heat.begin(), [&](Rgb8 colour) { return input.colour(colour); });
    canvas.paint([&](std::int32_t x, std::int32_t y) {
        return item(heat, std::min<std::int64_t>(item(writes, y * canvas.width_px + x), std::ssize(heat) - 1));
    });
    const std::int32_t legend_y = canvas.height_px - kFooter_px - 13;
    for (std::size_t i = 1; i < kHeat.size(); ++i) {
        const std::int32_t x = kTextMargin_px + static_cast<std::int32_t>(i - 1) * 15;
        canvas.box({x, legend_y, 14, 10}, kHeat[i]);
        canvas.write(x + 2, legend_y + 1, std::to_string(i) + (i + 1 == kHeat.size() ? "+" : ""));
    }
    const std::int64_t sum = std::accumulate(writes.begin(), writes.end(), std::int64_t{0});
    return {is_painter ? Figure{"pixels that the painter wrote", frame.counts().pixels_written, sum}
                       : Figure{"pixels written, each once", std::int64_t{canvas.width_px} * canvas.height_px, sum},
            frame.per_pixel("writes for each pixel", sum),
            {"most at one pixel", *std::max_element(writes.begin(), writes.end())}};
}

/// A grey for a depth: equal steps in log z, near is bright.
std::uint8_t depth_colour(InverseZ inverse_z, std::span<const std::uint8_t> greys) {
    const double z = 1 / number_of(std::max(inverse_z, InverseZ::ulp()));
    const double share = std::clamp((std::log2(1200.0) - std::log2(std::max(z, 1.0))) / 4.5, 0.0, 1.0);
    return item(greys, share * static_cast<double>(greys.size() - 1));
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

Figures draw_depth(const RowInput& input, Canvas& canvas) {
    RowInput rounded = input;
    rounded.settings.accuracy.inverse_z_bits = static_cast<std::int32_t>(input.values[0]);
    const MethodFrame frame(rounded, HiddenSurfaces::ZBuffer), right(input, HiddenSurfaces::Painter);
    std::vector<std::uint8_t> greys;
    for (int i = 0; i < 48; ++i) greys.push_back(input.colour(12 + i * 4, 16 + i * 4, 28 + i * 7 / 2));
    const std::uint8_t warning = input.colour(kGreen);
    canvas.paint([&](std::int32_t x, std::int32_t y) {
        const bool differs = frame.owners().row(y)[x] != right.owners().row(y)[x];
        return differs ? warning : depth_colour(item(frame.by.depths(), y * canvas.width_px + x), greys);
    });
    const Pixel checked{canvas.width_px / 8, canvas.height_px / 4};
    const double z = 1 / number_of(item(frame.by.depths(), checked.row * canvas.width_px + checked.column));
    const double by_tree = depth_by_tree(input.assets.demo_level, camera_in_hall(), input.mode, checked);
    const bool is_finest = is_exact(HiddenSurfaces::ZBuffer, rounded.settings.accuracy);
    return {{"pixels that go to another face than by the tree",
             count_differences(frame.owners().faces, right.owners().faces)},
            wrong_pixels("of them not equally deep", count_unlike(frame, right), is_finest),
            is_finest ? Figure{"z on the left wall, units", by_tree, z, 0.01, 2}
                      : Figure{"z on the left wall, units", decimal_text(z, "%.2f")},
            {"pixels written and then hidden", frame.counts().pixels_written - std::ssize(frame.picture.indices)}};
}

/// From near to far: a place from 0 to 1.
std::uint8_t order_colour(double share, const RowInput& input) {
    const auto part = [&](double phase) {
        return static_cast<int>(70 + 150 * (0.5 + 0.5 * std::cos(share * 4.2 - phase)) * (1 - share * 0.5));
    };
    return input.colour(part(0), part(1.6), part(3.6));
}

bool owns_pixel(const PixelOwners& owners, std::int32_t face) {
    return std::find(owners.faces.begin(), owners.faces.end(), face) != owners.faces.end();
}

Figures draw_tree_order(const RowInput& input, Canvas& canvas) {
    constexpr std::size_t kColours = 40;
    const MethodFrame frame(input, HiddenSurfaces::Painter), depths(input, HiddenSurfaces::ZBuffer);
    const ScannedFaces& scanned = frame.scanned();
    canvas.fill(kNight);
    std::vector<std::int32_t> order = back_to_front_by_tree(scanned);
    std::erase_if(order, [&](std::int32_t face) { return !owns_pixel(frame.owners(), face); });
    const auto painted = as_size(input.values[0]) * order.size() / 16;
    for (std::size_t place = 0; place < painted; ++place) {
        const auto step = static_cast<double>((order.size() - 1 - place) * kColours / order.size());
        const std::uint8_t colour = order_colour(step / (kColours - 1), input);
        for (const Span& span : scanned.spans_of(item(scanned.faces, order[place]))) {
            std::fill(canvas.row(span.y) + span.first, canvas.row(span.y) + span.end, colour);
            canvas.box({span.first, span.y, 1, 1}, kNight);
        }
    }
    return {wrong_pixels("pixels whose last face is not the nearest", count_unlike(frame, depths),
                         is_exact(HiddenSurfaces::ZBuffer, input.settings.accuracy)),
            {"faces painted", static_cast<std::int64_t>(painted)},
            {"of", std::ssize(order)}};
}

Figures draw_rays(const RowInput& input, Canvas& canvas) {
    const auto step = static_cast<std::int32_t>(input.values[0]);
    const ScreenMode mode{std::max(input.mode.width_px / step, 16), std::max(input.mode.height_px / step, 10),
                          input.mode.display};
    const MethodFrame frame(input, HiddenSurfaces::RayCasting, mode), right(input, HiddenSurfaces::SpanBuffer, mode);
    canvas.enlarge(frame.picture);
    const std::int64_t rays = std::ssize(frame.picture.indices);
    return {{"rays x faces", rays * std::ssize(frame.by.targets().opaque), frame.counts().ray_face_tests},
            {"rays", rays},
            {"pixels unlike the span buffer's", count_differences(frame.picture.indices, right.picture.indices)}};
}

}  // namespace

std::vector<Row> hidden_surface_rows() {
    return {{"hidden-surfaces",
             draw_hidden_surface_methods,
             {{"method",
               {kHiddenSurfaceNames.begin(), kHiddenSurfaceNames.end()},
               static_cast<std::int64_t>(HiddenSurfaces::PainterSorted)},
              {"differences", {"not marked", "marked"}, 1}}},
            {"overdraw", draw_overdraw, {{"method", {"painter", "span buffer"}}}},
            {"z-buffer", draw_depth, {{"fraction bits of 1/z", 12, 44, 1, 44}}},
            {"tree-order", draw_tree_order, {{"sixteenths of the faces painted", 1, 16, 1, 16}}},
            {"ray-casting", draw_rays, {{"a ray every ... pixels", 2, 20, 1, 2}}}};
}

}  // namespace oblong
