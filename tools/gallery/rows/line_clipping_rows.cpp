// Seed 2 (the lab): lines clipped in the view volume, before projection loses the depth.

#include <algorithm>
#include <cmath>

#include "engine/methods/clip_line.h"
#include "engine/view/clip_line.h"
#include "tools/gallery/diagram.h"
#include "tools/gallery/row.h"

namespace oblong {

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
