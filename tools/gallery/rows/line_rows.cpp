// Seed 3 (course notes): four ways to draw a line; seed 2 (the lab): lines clipped in the view volume.

#include <array>
#include <cmath>
#include <cstdio>

#include "engine/effects/colour_tables.h"
#include "engine/raster/line_walks.h"
#include "engine/raster/lines.h"
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

}  // namespace oblong
