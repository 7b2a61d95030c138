// Seed 3 (course notes): four ways to draw a line; seed 2 (the lab): lines clipped in the view volume.

#include "engine/effects/colour_tables.h"
#include "engine/methods/lines.h"
#include "engine/raster/line_walks.h"
#include "engine/raster/lines.h"
#include "engine/view/clip.h"
#include "tools/gallery/counted.h"
#include "tools/gallery/sketch.h"

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
    using Counting = Counted<std::int64_t>;
    const LinePath path = make_line_path(from, to, method == LineMethod::Naive);
    if (method == LineMethod::Naive) return operations_of_walk<NaiveWalk<Counting>>(path, false);
    if (method == LineMethod::Dda) return operations_of_walk<DdaWalk<Counting>>(path, false);
    if (method == LineMethod::Bresenham) return operations_of_walk<BresenhamWalk<Counting>>(path, false);
    return operations_of_walk<GuptaSproullWalk<Counting>>(path, true);
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
    const SidePicture picture(kGridColumns, kGridRows);
    draw_line(line.from, line.to, {method, 1}, picture);
    LineError error;
    for (std::int32_t y = 0; y < kGridRows; ++y)
        for (std::int32_t x = 0; x < kGridColumns; ++x)
            if (picture.row(y)[x] != 0) error.add(distance_to(line, x, y));
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

constexpr std::array<const char*, kLineMethodCount> kMethodNames{"naive", "DDA", "Bresenham", "Gupta-Sproull"};

/// A quarter of the canvas: the method's name, its pixels, and the true line over them.
void draw_method(int method, const NamedLine& line, Canvas& canvas) {
    constexpr std::int32_t kName_px = 10;
    const std::int32_t width = canvas.width_px / 2, height = (canvas.height_px - kHeader_px - kFooter_px) / 2,
                       x = method % 2 * width, y = kHeader_px + method / 2 * height;
    const auto by = static_cast<LineMethod>(method);
    canvas.write(x + kTextMargin_px, y + 2, item(kMethodNames, method));
    const CountedOperations cost = operations_of_line(by, line.from, line.to);
    const std::string counts = std::to_string(cost.additions) + "+ " + std::to_string(cost.multiplications) + "* " +
                               std::to_string(cost.divisions) + "/";
    canvas.write(x + width - kTextMargin_px - text_width_px(counts), y + 2, counts, kPale);

    const std::uint8_t lit = canvas.input.colour(kYellow);
    const Palette& palette = canvas.input.assets.colormap.palette;
    const FogTable blends = make_fog_table(palette, palette.colours[lit]);
    PixelGrid grid(canvas, {x, y + kName_px, width, height - kName_px}, kGridColumns, kGridRows, kSlate);
    draw_line(line.from, line.to, {by, lit, &blends.levels}, grid.picture);
    grid.show();
    grid.line({line.from.column + 0.5, line.from.row + 0.5}, {line.to.column + 0.5, line.to.row + 0.5}, kRed);
}

Figures draw_lines_row(const RowInput& input, Canvas& canvas) {
    const NamedLine& line = item(kLines, input.values[0]);
    canvas.fill(kNight);
    for (int method = 0; method < kLineMethodCount; ++method) draw_method(method, line, canvas);

    const LineError least = least_error(line), nearest = error_of(LineMethod::Bresenham, line),
                    naive = error_of(LineMethod::Naive, line), dda = error_of(LineMethod::Dda, line);
    const CountedOperations bresenham = operations_of_line(LineMethod::Bresenham, line.from, line.to);
    const auto text = [](const LineError& error) {
        return decimals_text({error.largest, error.rms()}, "%.3f", ", rms ");
    };
    return {{"Bresenham: farthest pixel from the line", least.largest, nearest.largest, 1e-12},
            {"Bresenham: multiplications and divisions", 0, bresenham.multiplications + bresenham.divisions},
            {"naive: pixels, one a column", std::abs(line.to.column - line.from.column) + 1, naive.pixels},
            {"Bresenham: pixels, one a step", least.pixels, nearest.pixels},
            {"Bresenham: rms distance from the line", least.rms(), nearest.rms(), 1e-12},
            {"DDA: farthest pixel, rms", text(dda)},
            {"naive: farthest pixel, rms", text(naive)}};
}

// Seed 2 (the lab): lines clipped in the view volume, before projection loses the depth.

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

void draw_volume(Diagram& diagram, double slope) {
    for (const double side : {-slope, slope}) {
        diagram.line({0, 0}, {side * kFront, kFront}, kDim);
        diagram.line({side * kFront, kFront}, {side * kBack, kBack}, kBlue);
    }
    for (const double depth : {kFront, kBack}) diagram.line({-slope * depth, depth}, {slope * depth, depth}, kBlue);
    diagram.label({0, 0}, "eye", kDim);
    diagram.label({slope * kFront, kFront}, "front", kBlue);
    diagram.label({slope * kBack, kBack}, "back", kBlue);
}

Figures draw_clipped_lines(const RowInput& input, Canvas& canvas) {
    const auto method = static_cast<LineClipping>(input.values[0]);
    const LineClipping other =
        method == LineClipping::LiangBarsky ? LineClipping::CohenSutherland : LineClipping::LiangBarsky;
    const Projection projection = make_projection(input.mode, Degrees::from_int(static_cast<int>(kFieldOfView)));
    const ViewVolume volume =
        make_view_volume(make_frustum(view_basis({}, {}, {}), projection), View::from_int(2), View::from_int(13));
    const double slope_x = input.mode.width_px / 2.0 / number_of(projection.x.multiplier),
                 slope_y = input.mode.height_px / 2.0 / number_of(projection.y.multiplier);
    Diagram diagram(canvas, {0, 6.5}, 17.5);
    draw_volume(diagram, slope_x);

    const auto from_above = [&](const Segment& line, Rgb8 colour) {
        diagram.line({line.from.x, line.from.z}, {line.to.x, line.to.z}, colour);
    };
    const auto view_of = [](const Vec& p) {
        return Vec3<View>{fixed_of<View>(p.x), fixed_of<View>(p.y), fixed_of<View>(p.z)};
    };
    double inside = 0, expected = 0, apart = 0;
    std::int64_t kept = 0;
    for (const Segment& line : some_lines(input.values[1])) {
        from_above(line, {120, 60, 60});
        expected += length_inside(line, slope_x, slope_y);
        const ViewLine whole{view_of(line.from), view_of(line.to)};
        const auto part = clip_line(volume, whole, method), by_other = clip_line(volume, whole, other);
        if (!part) continue;
        ++kept;
        const Vec from = vec_of(part->from), to = vec_of(part->to);
        inside += length(to - from);
        if (by_other)
            apart = std::max({apart, length(vec_of(by_other->from) - from), length(vec_of(by_other->to) - to)});
        from_above({from, to}, kYellow);
    }
    return {{"length inside, units, by 20,000 points a line", expected, inside, 1e-3 * input.number(1)},
            {"lines of which a part is kept", kept},
            {"units between the ends by both methods", 0, apart, 1e-3, 5}};
}

}  // namespace

std::vector<Row> line_rows() {
    return {{"lines", draw_lines_row, {choice_of("line", kLines)}},
            {"lines-clipped",
             draw_clipped_lines,
             {{"method", {"Cohen-Sutherland", "Liang-Barsky"}, 1}, {"lines", 1, 60, 1, 24}}}};
}

}  // namespace oblong
