// Seed 3 (course notes): four ways to draw a line; seed 2 (the lab): lines clipped in the view volume.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "engine/effects/colour_tables.h"
#include "engine/methods/lines.h"
#include "engine/raster/line_walks.h"
#include "engine/raster/lines.h"
#include "engine/view/clip.h"
#include "tools/gallery/counted.h"
#include "tools/gallery/diagram.h"
#include "tools/gallery/row.h"

namespace oblong {
namespace {

template <class Walk>
CountedOperations operations_of_walk(const LinePath& path, bool is_antialiased) {
    return operations_of([&] {
        Walk walk(path);
        for (std::int64_t step = 0; step <= path.steps; ++step, walk.next()) {
            (void)walk.minor();
            if constexpr (requires { walk.neighbours(); })
                if (is_antialiased) (void)walk.neighbours();
        }
    });
}

CountedOperations operations_of_line(LineMethod method, PixelPosition from, PixelPosition to) {
    const LinePath path = make_line_path(from, to, method == LineMethod::Naive);
    if (method == LineMethod::Naive) return operations_of_walk<NaiveWalk<Counted<std::int64_t>>>(path, false);
    if (method == LineMethod::Dda) return operations_of_walk<DdaWalk<Counted<std::int64_t>>>(path, false);
    if (method == LineMethod::Bresenham) return operations_of_walk<BresenhamWalk<Counted<std::int64_t>>>(path, false);
    return operations_of_walk<GuptaSproullWalk<Counted<std::int64_t>>>(path, true);
}

struct NamedLine {
    const char* name;
    PixelPosition from, to;
};
constexpr std::int32_t kGridColumns = 24, kGridRows = 12;
constexpr std::array<NamedLine, 5> kLines{{{"flat", {1, 3}, {22, 8}},
                                           {"steep", {9, 0}, {13, 11}},
                                           {"falling", {2, 11}, {20, 1}},
                                           {"diagonal", {6, 0}, {17, 11}},
                                           {"upright", {12, 0}, {12, 11}}}};

/// The distances of a picture's lit pixels from a line.
struct LineError {
    double largest = 0, mean_square = 0;
    std::int64_t pixels = 0;

    void add(double distance) {
        largest = std::max(largest, distance);
        mean_square += distance * distance;
        ++pixels;
    }
    double rms() const { return pixels == 0 ? 0 : std::sqrt(mean_square / static_cast<double>(pixels)); }
};

double distance_to(const NamedLine& line, double x, double y) {
    const double dx = line.to.column - line.from.column, dy = line.to.row - line.from.row;
    return std::abs(dx * (y - line.from.row) - dy * (x - line.from.column)) / std::hypot(dx, dy);
}

LineError error_of(LineMethod method, const NamedLine& line) {
    std::vector<std::uint8_t> pixels(pixel_count(kGridColumns, kGridRows), 0);
    const Framebuffer canvas{pixels.data(), kGridColumns, kGridRows, kGridColumns};
    draw_line(line.from, line.to, {method, 1}, canvas);
    LineError error;
    for (std::int32_t y = 0; y < kGridRows; ++y)
        for (std::int32_t x = 0; x < kGridColumns; ++x)
            if (canvas.row(y)[x] != 0) error.add(distance_to(line, x, y));
    return error;
}

/// The least possible error: in each step along the major axis, the nearest pixel.
LineError least_error(const NamedLine& line) {
    const double dx = line.to.column - line.from.column, dy = line.to.row - line.from.row;
    const int steps = static_cast<int>(std::max(std::abs(dx), std::abs(dy)));
    LineError error;
    for (int step = 0; step <= steps; ++step) {
        const double x = line.from.column + dx * step / steps, y = line.from.row + dy * step / steps;
        error.add(std::abs(dy) > std::abs(dx) ? distance_to(line, std::round(x), y)
                                              : distance_to(line, x, std::round(y)));
    }
    return error;
}

std::string counts_text(const CountedOperations& operations) {
    return std::to_string(operations.additions) + "+ " + std::to_string(operations.multiplications) + "* " +
           std::to_string(operations.divisions) + "/";
}

std::string error_text(const LineError& error) {
    char text[64];
    std::snprintf(text, sizeof text, "%.3f, rms %.3f", error.largest, error.rms());
    return text;
}

const char* name_of(LineMethod method) {
    constexpr std::array<const char*, kLineMethodCount> kNames{"naive", "DDA", "Bresenham", "Gupta-Sproull"};
    return item(kNames, method);
}

/// A quarter of the canvas: the method's name, its pixels, and the true line over them.
void draw_method(LineMethod method, const NamedLine& line, const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    const int index = static_cast<int>(method);
    constexpr std::int32_t kName_px = 10;
    const std::int32_t width = canvas.width_px / 2, height = (canvas.height_px - kHeader_px - kFooter_px) / 2;
    const Area quarter{index % 2 * width, kHeader_px + index / 2 * height, width, height};
    draw_text(canvas, quarter.x + kTextMargin_px, quarter.y + 2, name_of(method), assets.text);
    const std::string counts = counts_text(operations_of_line(method, line.from, line.to));
    draw_text(canvas, quarter.x + width - kTextMargin_px - text_width_px(counts), quarter.y + 2, counts,
              {assets.colour(150, 160, 180), assets.text.dark});

    const std::uint8_t ground = assets.colour(30, 36, 52), lit = assets.colour(240, 200, 96);
    const Palette& palette = assets.colormap.palette;
    const FogTable blends = make_fog_table(palette, palette.colours[lit]);
    PixelGrid grid(input, canvas, {quarter.x, quarter.y + kName_px, width, height - kName_px}, kGridColumns, kGridRows,
                   ground);
    draw_line(line.from, line.to, {method, lit, &blends.levels}, grid.picture());
    grid.show(assets.colour(16, 18, 28));
    const auto centre = [](PixelPosition pixel) { return PlanePoint{pixel.column + 0.5, pixel.row + 0.5}; };
    grid.line(centre(line.from), centre(line.to), assets.colour(220, 72, 64));
}

Figures draw_lines_row(const RowInput& input, Framebuffer canvas) {
    const NamedLine& line = item(kLines, input.values[0]);
    fill(canvas, input.assets.colour(16, 18, 28));
    for (int method = 0; method < kLineMethodCount; ++method)
        draw_method(static_cast<LineMethod>(method), line, input, canvas);

    const LineError least = least_error(line), nearest = error_of(LineMethod::Bresenham, line);
    const std::int64_t across = std::abs(line.to.column - line.from.column);
    const CountedOperations bresenham = operations_of_line(LineMethod::Bresenham, line.from, line.to);
    return {
        number_figure("Bresenham: farthest pixel from the line", least.largest, nearest.largest, 1e-12),
        count_figure("Bresenham: multiplications and divisions", 0, bresenham.multiplications + bresenham.divisions),
        count_figure("naive: pixels, one a column", across + 1, error_of(LineMethod::Naive, line).pixels),
        count_figure("Bresenham: pixels, one a step", least.pixels, nearest.pixels),
        number_figure("Bresenham: rms distance from the line", least.rms(), nearest.rms(), 1e-12),
        measured("DDA: farthest pixel, rms", error_text(error_of(LineMethod::Dda, line))),
        measured("naive: farthest pixel, rms", error_text(error_of(LineMethod::Naive, line)))};
}

}  // namespace

std::vector<Row> line_rows() {
    return {{"lines", draw_lines_row, {choice_of("line", kLines)}}};
}

// Seed 2 (the lab): lines clipped in the view volume, before projection loses the depth.

namespace {

constexpr double kFront = 2, kBack = 13, kFieldOfView = 80;

/// x right, y up, z ahead.
struct Segment {
    Vec from, to;
};

/// Lines around the volume, evenly spread by fractions of multiples of the golden ratio.
std::vector<Segment> some_lines(std::int64_t count) {
    const auto spread = [](int number, double least, double most) {
        const double whole = number * 0.6180339887498949;
        return least + (whole - std::floor(whole)) * (most - least);
    };
    std::vector<Segment> lines;
    for (int i = 0; i < count; ++i) {
        const auto place = [&](int first) {
            return Vec{spread(first, -13, 13), spread(first * 5 + 2, -5, 5), spread(first * 3 + 1, -2, 16)};
        };
        lines.push_back({place(i * i + 3 * i), place(2 * i * i + i + 5)});
    }
    return lines;
}

/// The share of a line that is inside, by the midpoints of 20,000 parts.
double length_inside(const Segment& line, double slope_x, double slope_y) {
    constexpr int kParts = 20'000;
    int inside = 0;
    for (int i = 0; i < kParts; ++i) {
        const Vec p = line.from + (line.to - line.from) * ((i + 0.5) / kParts);
        inside += p.z >= kFront && p.z <= kBack && std::abs(p.x) <= slope_x * p.z && std::abs(p.y) <= slope_y * p.z;
    }
    return length(line.to - line.from) * inside / kParts;
}

Vec3<View> view_of(const Vec& place) {
    return {fixed_of<View>(place.x), fixed_of<View>(place.y), fixed_of<View>(place.z)};
}

void draw_volume(Diagram& diagram, double slope, std::uint8_t colour, std::uint8_t faint) {
    for (const double side : {-slope, slope}) {
        diagram.line({0, 0}, {side * kFront, kFront}, faint);
        diagram.line({side * kFront, kFront}, {side * kBack, kBack}, colour);
    }
    diagram.line({-slope * kFront, kFront}, {slope * kFront, kFront}, colour);
    diagram.line({-slope * kBack, kBack}, {slope * kBack, kBack}, colour);
    diagram.text({0, 0}, "eye", faint);
    diagram.text({slope * kFront, kFront}, "front", colour);
    diagram.text({slope * kBack, kBack}, "back", colour);
}

Figures draw_clipped_lines(const RowInput& input, Framebuffer canvas) {
    const auto method = static_cast<LineClipping>(input.values[0]);
    const LineClipping other =
        method == LineClipping::LiangBarsky ? LineClipping::CohenSutherland : LineClipping::LiangBarsky;
    const Projection projection = make_projection(input.mode, Degrees::from_int(static_cast<int>(kFieldOfView)));
    const ViewVolume volume =
        make_view_volume(make_frustum(view_basis({}, {}, {}), projection), View::from_int(2), View::from_int(13));
    const double slope_x = input.mode.width_px / 2.0 / number_of(projection.x.multiplier),
                 slope_y = input.mode.height_px / 2.0 / number_of(projection.y.multiplier);
    Diagram diagram(input, canvas, {0, 6.5}, 17.5);
    diagram.fill(input.colour(18, 22, 34));
    draw_volume(diagram, slope_x, input.colour(90, 130, 220), input.colour(80, 88, 110));

    double inside = 0, expected = 0, apart = 0;
    std::int64_t kept = 0;
    const std::vector<Segment> lines = some_lines(input.values[1]);
    for (const Segment& line : lines) {
        diagram.line({line.from.x, line.from.z}, {line.to.x, line.to.z}, input.colour(120, 60, 60));
        expected += length_inside(line, slope_x, slope_y);
        const ViewLine whole{view_of(line.from), view_of(line.to)};
        const auto part = clip_line(volume, whole, method), by_other = clip_line(volume, whole, other);
        if (!part) continue;
        ++kept;
        const Vec from = vec_of(part->from), to = vec_of(part->to);
        inside += length(to - from);
        if (by_other)
            apart = std::max({apart, length(vec_of(by_other->from) - from), length(vec_of(by_other->to) - to)});
        diagram.line({from.x, from.z}, {to.x, to.z}, input.colour(250, 200, 110));
    }
    const auto count = static_cast<double>(lines.size());
    return {number_figure("length inside, units, by 20,000 points a line", expected, inside, 1e-3 * count),
            measured("lines of which a part is kept", kept),
            number_figure("units between the ends by both methods", 0, apart, 1e-3, 5)};
}

}  // namespace

std::vector<Row> line_clipping_rows() {
    return {{"lines-clipped",
             draw_clipped_lines,
             {choice_parameter("method", {"Cohen-Sutherland", "Liang-Barsky"}, 1), {"lines", 1, 60, 1, 24}}}};
}

}  // namespace oblong
