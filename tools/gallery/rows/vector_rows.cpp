// Seed 5 (Abrash): dot products, cross products and frames of reference, and what seed 1 says of components.

#include <cmath>
#include <numbers>
#include <optional>

#include "engine/draw/drawing.h"
#include "engine/fixed/trig.h"
#include "engine/math/matrix.h"
#include "engine/math/vec.h"
#include "engine/methods/lines.h"
#include "engine/methods/transforms.h"
#include "tools/gallery/counted.h"
#include "tools/gallery/diagram.h"
#include "tools/gallery/row.h"

namespace oblong {

namespace {

using Whole = Fixed<std::int32_t, 0>;

Vec3<Whole> whole(std::int32_t x, std::int32_t y, std::int32_t z) {
    return {Whole::from_int(x), Whole::from_int(y), Whole::from_int(z)};
}

/// The unit vector at this angle from +x in the plane of x and y, by the engine's sines.
Vec3<Unit> direction_at(std::int64_t degrees) {
    const Angle angle = degrees_to_angle(Degrees::from_int(degrees));
    return {cosine(angle), sine(angle), {}};
}
PlanePoint plane_point(const Vec3<Unit>& v) {
    return {number_of(v.x), number_of(v.y)};
}

/// The colours of all diagrams here.
struct Colours {
    std::uint8_t ground, grid, first, second, result, text;
    explicit Colours(const GalleryAssets& assets)
        : ground(assets.colour(20, 24, 36)),
          grid(assets.colour(70, 80, 104)),
          first(assets.colour(220, 150, 60)),
          second(assets.colour(110, 160, 230)),
          result(assets.colour(110, 220, 120)),
          text(assets.colour(220, 220, 210)) {}
};

void draw_axes(Diagram& diagram, double length, std::uint8_t colour) {
    diagram.line({-length, 0}, {length, 0}, colour);
    diagram.line({0, -length}, {0, length}, colour);
}

Figures draw_dot_product(const RowInput& input, Framebuffer canvas) {
    const std::int64_t degrees = input.values[0];
    const Colours colours(input.assets);
    const Vec3<Unit> u = direction_at(0), v = direction_at(degrees);
    const double product = number_of(dot(u, v));
    Diagram diagram(input, canvas, {0, 0}, 2.4);
    diagram.fill(colours.ground);
    draw_axes(diagram, 1.12, colours.grid);
    diagram.circle({0, 0}, 1, colours.grid);
    diagram.line(plane_point(v), {product, 0}, colours.grid);
    diagram.arrow({0, 0}, plane_point(u), colours.second);
    diagram.arrow({0, 0}, plane_point(v), colours.first);
    diagram.line({0, 0}, {product, 0}, colours.result);
    diagram.line({0, 0.012}, {product, 0.012}, colours.result);
    diagram.disc({product, 0}, 0.025, colours.result);
    diagram.text({1, 0}, "U", colours.second, 4, -9);
    diagram.text(plane_point(v) * 1.08, "V", colours.first, -2, -3);
    diagram.text({-1.95, 1.0}, std::to_string(degrees) + " degrees", colours.text);
    diagram.text({-1.95, 0.84}, "U . V = " + decimal_text(product), colours.result);

    const auto a = whole(1, 2, 3), b = whole(4, -5, 6);
    const std::int64_t by_cosines = floor_of(dot(a, a) + dot(b, b) - dot(a - b, a - b)) / 2;
    const Angle between = arctangent2(cross(u, v).z.raw, dot(u, v).raw);
    return {number_figure("U . V of unit vectors: cos", std::cos(input.radians(0)), product, 1e-4),
            number_figure("the angle, from both products, degrees", static_cast<double>(degrees),
                          between.bam * 360.0 / 65536, 0.006, 2),
            count_figure("(1 2 3) . (4 -5 6) by the law of cosines", by_cosines, floor_of(dot(a, b))),
            number_figure("length of (5 0 5)", 5 * std::numbers::sqrt2, number_of(length(world_point(5, 0, 5))),
                          1.0 / 4096)};
}

/// Axes of length 1 in a plane, with `degrees` between them.
Basis crooked_axes(std::int64_t degrees) {
    return {direction_at(0), direction_at(degrees), {{}, {}, Unit::from_int(1)}};
}

void draw_lattice(Diagram& diagram, PlanePoint i, PlanePoint j, std::uint8_t colour) {
    for (int line = -2; line <= 3; ++line) {
        diagram.line(i * line + j * -2, i * line + j * 3, colour);
        diagram.line(j * line + i * -2, j * line + i * 3, colour);
    }
}

Figures draw_orthonormal(const RowInput& input, Framebuffer canvas) {
    const Colours colours(input.assets);
    const Basis given = crooked_axes(input.values[0]);
    const Basis axes = input.values[1] == 1 ? orthonormalised(given) : given;
    const PlanePoint i = plane_point(axes.right), j = plane_point(axes.up), a = i + j;
    Diagram diagram(input, canvas, {0.5, 0.55}, 2.6);
    diagram.fill(colours.ground);
    draw_lattice(diagram, i, j, colours.grid);
    diagram.arrow({0, 0}, i, colours.second);
    diagram.arrow({0, 0}, j, colours.second);
    diagram.arrow({0, 0}, a, colours.first);
    diagram.text(i, "i", colours.second, 3, 2);
    diagram.text(j * 1.08, "j", colours.second, -8, -6);
    diagram.text(a, "a = i + j", colours.first, 4, -3);
    const double true_square = a.x * a.x + a.y * a.y;
    const double cosine_of_axes = input.values[1] == 1 ? 0 : std::abs(std::cos(input.radians(0)));
    const auto r = whole(1, 0, 0), s = whole(1, 1, 0);
    return {number_figure("flaw: i . j", cosine_of_axes, number_of(orthonormal_flaw(axes)), 1e-4),
            number_figure("|a| |a| is 2 + 2 i . j; its components say 2", 2 + 2 * (i.x * j.x + i.y * j.y), true_square,
                          1e-6),
            count_figure("axes are orthonormal", input.values[0] == 90 || input.values[1] == 1, is_orthonormal(axes)),
            count_figure("|i + j|^2 with i = (1 0), j = (1 1): not 2", 5, floor_of(dot(r + s, r + s)))};
}

/// A ball lit from the side: each pixel's normal times the light's direction.
void draw_lit_ball(const RowInput& input, Diagram& diagram, PlanePoint centre, double radius,
                   const Vec3<Unit>& to_light, Framebuffer canvas) {
    const auto px = [&](PlanePoint at) { return diagram.on_canvas(at); };
    const PlanePoint low = px({centre.x - radius, centre.y - radius}),
                     high = px({centre.x + radius, centre.y + radius});
    for (auto row = static_cast<std::int32_t>(high.y); row <= static_cast<std::int32_t>(low.y); ++row)
        for (auto column = static_cast<std::int32_t>(low.x); column <= static_cast<std::int32_t>(high.x); ++column) {
            const double x = 2 * (column + 0.5 - low.x) / (high.x - low.x) - 1,
                         y = 1 - 2 * (row + 0.5 - high.y) / (low.y - high.y);
            if (x * x + y * y > 1) continue;
            const Vec3<Unit> normal{fixed_of<Unit>(x), fixed_of<Unit>(y), fixed_of<Unit>(std::sqrt(1 - x * x - y * y))};
            const int light = static_cast<int>(std::max(number_of(dot(normal, to_light)), 0.0) * 200);
            set_pixel(canvas, column, row, input.assets.colour(40 + light, 36 + light * 9 / 10, 34 + light * 7 / 10));
        }
}

Vec3<Counted<double>> counted(const Vec3<Unit>& vector) {
    return {number_of(vector.x), number_of(vector.y), number_of(vector.z)};
}

Figures draw_lighting(const RowInput& input, Framebuffer canvas) {
    const std::int64_t degrees = input.values[0];
    const Colours colours(input.assets);
    Diagram diagram(input, canvas, {0, 0}, 2.2);
    diagram.fill(colours.ground);
    const PlanePoint foot{-0.9, -0.5}, ball{0.75, 0};
    const Vec3<Unit> normal = direction_at(90), to_light = direction_at(90 - degrees);
    const double share = std::max(number_of(dot(normal, to_light)), 0.0);
    draw_lit_ball(input, diagram, ball, 0.8, to_light, canvas);
    diagram.circle(ball, 0.8, colours.grid);
    diagram.rectangle({foot.x - 0.55, foot.y - 0.08}, {foot.x + 0.55, foot.y},
                      input.assets.colour(40 + static_cast<int>(share * 200), 36 + static_cast<int>(share * 180),
                                          34 + static_cast<int>(share * 140)));
    diagram.arrow(foot, foot + plane_point(normal), colours.second);
    diagram.arrow(foot + plane_point(to_light) * 1.15, foot + plane_point(to_light) * 0.12, colours.first);
    diagram.text(foot + plane_point(normal), "N", colours.second, -9, 2);
    diagram.text(foot + plane_point(to_light) * 1.2, "D", colours.first, -2, -3);
    diagram.text({-1.65, -0.75}, "I = N . -D = " + decimal_text(share), colours.result);
    const CountedOperations cost =
        operations_of([&] { lit(counted(normal), counted(to_light), Counted<double>(200)); });
    return {number_figure("share of the light: cos, 0 or more", std::max(std::cos(input.radians(0)), 0.0), share, 1e-4),
            number_figure("of a light of 200", 200 * std::max(std::cos(input.radians(0)), 0.0), 200 * share, 0.02, 2),
            {"counted: four multiplications, two additions", "4 * 0 / 2 +", cost.text(),
             cost == CountedOperations{4, 0, 2}}};
}

/// The position of a point on the diagram: x right, y up, z to the lower left.
PlanePoint seen(const Vec3<Unit>& v) {
    return {number_of(v.x) - 0.5 * number_of(v.z), number_of(v.y) - 0.35 * number_of(v.z)};
}

Figures draw_cross_product(const RowInput& input, Framebuffer canvas) {
    const std::int64_t degrees = input.values[0];
    const Colours colours(input.assets);
    // In the plane of x and z, so that the product is along y.
    const Vec3<Unit> u{{}, {}, Unit::from_int(1)}, v{sine(input.angle(0)), {}, cosine(input.angle(0))};
    const auto product = cross(u, v);
    const Vec3<Unit> result = convert<Unit>(product);
    const PlanePoint far_corner = seen(u) + seen(v);
    Diagram diagram(input, canvas, {0.1, 0.1}, 2.4);
    diagram.fill(colours.ground);
    diagram.line(seen(u), far_corner, colours.grid);
    diagram.line(seen(v), far_corner, colours.grid);
    diagram.arrow({0, 0}, seen(u), colours.second);
    diagram.arrow({0, 0}, seen(v), colours.first);
    diagram.arrow({0, 0}, seen(result), colours.result);
    diagram.text(seen(u), "U", colours.second, -10, 2);
    diagram.text(seen(v), "V", colours.first, 4, -3);
    diagram.text(seen(result), "U x V", colours.result, 5, -4);
    diagram.text({-1.7, 1.1}, std::to_string(degrees) + " degrees", colours.text);
    const Vec3<Unit> third = normalised(product);
    const Basis axes{v, third, u};
    const auto listed = cross(whole(1, 2, 3), whole(4, 5, 6));
    const bool is_listed = listed == decltype(listed){{-3}, {6}, {-3}};
    return {
        number_figure("|U x V|, the area between them: sin", std::sin(input.radians(0)), length(vec_of(product)), 1e-4),
        count_figure("at right angles to U and V: both dot products", 0, dot(third, u).raw + dot(third, v).raw),
        count_figure("U, V, U x V made of length 1 are axes", degrees == 90, is_orthonormal(axes)),
        {"(1 2 3) x (4 5 6)", "-3 6 -3",
         decimal_text(number_of(listed.x), "%.0f") + " " + decimal_text(number_of(listed.y), "%.0f") + " " +
             decimal_text(number_of(listed.z), "%.0f"),
         is_listed},
        count_figure("parallel vectors give a normal", 0,
                     normalised(cross(whole(1, 2, 3), whole(-2, -4, -6))) != Vec3<Unit>{})};
}

Figures draw_rotation(const RowInput& input, Framebuffer canvas) {
    const std::int64_t degrees = input.values[0];
    const Colours colours(input.assets);
    const Basis axes{direction_at(degrees), direction_at(degrees + 90), {{}, {}, Unit::from_int(1)}};
    const Vec3<Unit> point{Unit::from_raw(3 << 27), Unit::from_raw(3 << 28), {}};  // (0.375, 0.75)
    const Vec3<Unit> turned = project_onto_axes(point, axes);
    const Vec3<Unit> restored = sum_along_axes(turned, axes);
    const PlanePoint p = plane_point(point), right = plane_point(axes.right), up = plane_point(axes.up);
    const PlanePoint on_right = right * number_of(turned.x), on_up = up * number_of(turned.y);
    Diagram diagram(input, canvas, {0, 0}, 2.4);
    diagram.fill(colours.ground);
    draw_axes(diagram, 1.12, colours.grid);
    diagram.arrow({0, 0}, right, colours.second);
    diagram.arrow({0, 0}, up, colours.second);
    diagram.line(p, on_right, colours.grid);
    diagram.line(p, on_up, colours.grid);
    diagram.arrow({0, 0}, p, colours.first);
    diagram.disc(on_right, 0.025, colours.result);
    diagram.disc(on_up, 0.025, colours.result);
    diagram.text(p, "P", colours.first, 4, -4);
    diagram.text(right * 1.06, "x'", colours.second);
    diagram.text(up * 1.06, "y'", colours.second);
    diagram.text({-1.9, 1.0}, "P . x' = " + decimal_text(number_of(turned.x)), colours.result);
    diagram.text({-1.9, 0.84}, "P . y' = " + decimal_text(number_of(turned.y)), colours.result);
    const std::array counted_axes{counted(axes.right), counted(axes.up), counted(axes.forward)};
    const CountedOperations cost = operations_of([&] { rotate_by_projection(counted(point), counted_axes); });
    diagram.text({-1.9, 0.6}, "in 3-D: three", colours.text);
    diagram.text({-1.9, 0.46}, "dot products", colours.text);
    diagram.text({-1.9, 0.32}, cost.text(), colours.text);
    const double cos = std::cos(input.radians(0)), sin = std::sin(input.radians(0));
    const Vec3<Entry> by_matrix = rotation_matrix(axes) * convert<Entry>(point);
    return {
        number_figure("x' by cos and sin", 0.375 * cos + 0.75 * sin, number_of(turned.x), 1e-4),
        number_figure("y' by cos and sin", 0.75 * cos - 0.375 * sin, number_of(turned.y), 1e-4),
        {"counted: three dot products", "9 * 0 / 6 +", cost.text(), cost == CountedOperations{9, 0, 6}},
        number_figure("x' by the matrix whose rows are the axes", number_of(by_matrix.x), number_of(turned.x), 1e-8, 6),
        number_figure("x again, the sum along the axes", 0.375, number_of(restored.x), 1e-8, 6)};
}

Figures draw_line_and_plane(const RowInput& input, Framebuffer canvas) {
    const auto end_z = static_cast<std::int32_t>(input.values[0]);
    const Colours colours(input.assets);
    const Plane plane = plane_through(world_point(0, 0, 5), {{}, {}, Unit::from_int(1)});
    const Vec3<World> start = world_point(0, 0, 9), end = world_point(4, 2, end_z), point = world_point(-3, 2, 10);
    const std::optional<LineHit> line = intersect_line(start, end, plane),
                                 segment = intersect_segment(start, end, plane);
    const auto on_diagram = [](const Vec3<World>& p) { return PlanePoint{number_of(p.x), number_of(p.z)}; };
    Diagram diagram(input, canvas, {1, 6}, 13);
    diagram.fill(colours.ground);
    diagram.rectangle({-20, 4.9}, {20, 5}, colours.grid);
    diagram.arrow({8, 5}, {8, 7}, colours.grid);
    diagram.text({8, 7}, "N", colours.grid, 4, 0);
    diagram.line(on_diagram(point), {-3, 5}, colours.second);
    diagram.disc(on_diagram(point), 0.15, colours.second);
    diagram.text(on_diagram(point), "P", colours.second, 5, -4);
    diagram.text({-3, 7.5}, decimal_text(number_of(distance_to_plane(point, plane)), "%.0f"), colours.second, 4, -4);
    diagram.line(on_diagram(start), on_diagram(end), colours.first);
    diagram.disc(on_diagram(start), 0.15, colours.first);
    diagram.disc(on_diagram(end), 0.15, colours.first);
    diagram.text(on_diagram(start), "start", colours.first, 5, -6);
    diagram.text(on_diagram(end), "end", colours.first, 5, -4);
    if (segment) diagram.disc(on_diagram(segment->world_point), 0.2, colours.result);
    const double t = 4.0 / (9 - end_z);
    Figures figures;
    figures = {number_figure("distance of P = (1 2 10) from z = 5", 5,
                             number_of(distance_to_plane(world_point(1, 2, 10), plane)), 0),
               count_figure("the segment meets the plane", end_z <= 5, segment.has_value())};
    if (end_z == 9)
        figures.push_back(count_figure("a parallel line meets it", 0, line.has_value()));
    else
        figures.push_back(
            number_figure("t along the line: D1 / (D1 - D2)", t, line ? number_of(line->along) : 0, 1e-9));
    if (line)
        figures.push_back({"where the line meets it", decimal_text(4 * t) + " " + decimal_text(2 * t) + " 5.000",
                           decimal_text(number_of(line->world_point.x)) + " " +
                               decimal_text(number_of(line->world_point.y)) + " " +
                               decimal_text(number_of(line->world_point.z)),
                           std::abs(number_of(line->world_point.x) - 4 * t) <= 0.5 / 4096 &&
                               line->world_point.z == World::from_int(5)});
    return figures;
}

}  // namespace

std::vector<Row> vector_rows() {
    const Parameter angle{"angle, degrees", 0, 345, 15, 60};
    return {{"dot-product", draw_dot_product, {angle}},
            {"orthonormal-axes",
             draw_orthonormal,
             {{"angle between the axes", 30, 150, 10, 50}, choice_parameter("axes", {"as given", "made orthonormal"})}},
            {"lighting-by-dot-product", draw_lighting, {{"angle of the light, degrees", -90, 90, 15, 45}}},
            {"cross-product", draw_cross_product, {{"angle from U to V, degrees", 15, 165, 15, 90}}},
            {"rotation-by-projection", draw_rotation, {{"angle of the new axes, degrees", 0, 345, 15, 30}}},
            {"line-and-plane", draw_line_and_plane, {{"z of the line's end", 1, 9, 1, 1}}}};
}

}  // namespace oblong
