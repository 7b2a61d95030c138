// Seed 5 (Abrash): dot products, cross products and frames of reference, and what seed 1 says of components.

#include "engine/methods/lines.h"
#include "engine/methods/transforms.h"
#include "tools/gallery/canvas.h"
#include "tools/gallery/counted.h"

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

/// What stands for what in all diagrams here.
constexpr Rgb8 kGridColour = kSteel, kFirstColour = kAmber, kSecondColour = kSky, kResultColour = kGreen,
               kTextColour = kBone;

void draw_plane_axes(Diagram& diagram) {
    diagram.line({-1.12, 0}, {1.12, 0}, kGridColour);
    diagram.line({0, -1.12}, {0, 1.12}, kGridColour);
}

Figures draw_dot_product(const RowInput& input, Canvas& canvas) {
    const std::int64_t degrees = input.values[0];
    const Vec3<Unit> u = direction_at(0), v = direction_at(degrees);
    const double product = number_of(dot(u, v));
    Diagram diagram(canvas, {0, 0}, 2.4);
    draw_plane_axes(diagram);
    diagram.circle({0, 0}, 1, kGridColour);
    diagram.line(v, {product, 0}, kGridColour);
    diagram.arrow({0, 0}, {1, 0}, kSecondColour, "U", 4, -9);
    diagram.arrow({0, 0}, vec_of(v), kFirstColour);
    for (const double y : {0.0, 0.012}) diagram.line({0, y}, {product, y}, kResultColour);
    diagram.disc({product, 0}, 0.025, kResultColour);
    diagram.label(vec_of(v) * 1.08, "V", kFirstColour, -2, -3);
    diagram.label({-1.95, 1.0}, std::to_string(degrees) + " degrees", kTextColour);
    diagram.label({-1.95, 0.84}, "U . V = " + decimal_text(product), kResultColour);

    const auto a = whole(1, 2, 3), b = whole(4, -5, 6);
    const Angle between = arctangent2(cross(u, v).z.raw, dot(u, v).raw);
    return {{"U . V of unit vectors: cos", std::cos(input.radians(0)), product, 1e-4},
            {"the angle, from both products, degrees", degrees, between.bam * 360.0 / 65536, 0.006, 2},
            {"(1 2 3) . (4 -5 6) by the law of cosines", floor_of(dot(a, a) + dot(b, b) - dot(a - b, a - b)) / 2,
             floor_of(dot(a, b))},
            {"length of (5 0 5)", 5 * std::numbers::sqrt2, length(world_point(5, 0, 5)), 1.0 / 4096}};
}

Figures draw_orthonormal(const RowInput& input, Canvas& canvas) {
    // Axes of length 1 in a plane.
    const Basis given{direction_at(0), direction_at(input.values[0]), {{}, {}, Unit::from_int(1)}};
    const Basis axes = input.values[1] == 1 ? orthonormalised(given) : given;
    const Vec i = vec_of(axes.right), j = vec_of(axes.up), a = i + j;
    Diagram diagram(canvas, {0.5, 0.55}, 2.6);
    for (int line = -2; line <= 3; ++line) {
        diagram.line(i * line + j * -2, i * line + j * 3, kGridColour);
        diagram.line(j * line + i * -2, j * line + i * 3, kGridColour);
    }
    diagram.arrow({0, 0}, i, kSecondColour, "i", 3, 2);
    diagram.arrow({0, 0}, j, kSecondColour);
    diagram.arrow({0, 0}, a, kFirstColour, "a = i + j", 4, -3);
    diagram.label(j * 1.08, "j", kSecondColour, -8, -6);
    const auto r = whole(1, 0, 0), s = whole(1, 1, 0);
    return {
        {"flaw: i . j", input.values[1] == 1 ? 0 : std::abs(std::cos(input.radians(0))), orthonormal_flaw(axes), 1e-4},
        {"|a| |a| is 2 + 2 i . j; its components say 2", 2 + 2 * dot(i, j), dot(a, a), 1e-6},
        {"axes are orthonormal", input.values[0] == 90 || input.values[1] == 1, is_orthonormal(axes)},
        {"|i + j|^2 with i = (1 0), j = (1 1): not 2", 5, floor_of(dot(r + s, r + s))}};
}

/// A ball of radius 0.8, lit from the side: each pixel's normal times the light's direction.
void draw_lit_ball(Diagram& diagram, const Vec& centre, const Vec3<Unit>& to_light) {
    const Vec corner{0.8, 0.8}, low = diagram.pixel_of(centre - corner), high = diagram.pixel_of(centre + corner);
    for (auto row = static_cast<std::int32_t>(high.y); row <= static_cast<std::int32_t>(low.y); ++row)
        for (auto column = static_cast<std::int32_t>(low.x); column <= static_cast<std::int32_t>(high.x); ++column) {
            const double x = 2 * (column + 0.5 - low.x) / (high.x - low.x) - 1,
                         y = 1 - 2 * (row + 0.5 - high.y) / (low.y - high.y);
            if (x * x + y * y > 1) continue;
            const Vec3<Unit> normal{fixed_of<Unit>(x), fixed_of<Unit>(y), fixed_of<Unit>(std::sqrt(1 - x * x - y * y))};
            const int light = static_cast<int>(std::max(number_of(dot(normal, to_light)), 0.0) * 200);
            set_pixel(diagram, column, row, diagram.input.colour(40 + light, 36 + light * 9 / 10, 34 + light * 7 / 10));
        }
    diagram.circle(centre, 0.8, kGridColour);
}

Vec3<Counted<double>> counted(const Vec3<Unit>& vector) {
    return {number_of(vector.x), number_of(vector.y), number_of(vector.z)};
}

Figures draw_lighting(const RowInput& input, Canvas& canvas) {
    Diagram diagram(canvas, {0, 0}, 2.2);
    const Vec foot{-0.9, -0.5};
    const Vec3<Unit> normal = direction_at(90), to_light = direction_at(90 - input.values[0]);
    const double share = std::max(number_of(dot(normal, to_light)), 0.0),
                 expected = std::max(std::cos(input.radians(0)), 0.0);
    const auto lit_by = [share](int dark, int most) {
        return static_cast<std::uint8_t>(dark + static_cast<int>(share * most));
    };
    draw_lit_ball(diagram, {0.75, 0}, to_light);
    diagram.rectangle(foot - Vec{0.55, 0.08}, foot + Vec{0.55, 0}, {lit_by(40, 200), lit_by(36, 180), lit_by(34, 140)});
    diagram.arrow(foot, foot + vec_of(normal), kSecondColour);
    diagram.arrow(foot + vec_of(to_light) * 1.15, foot + vec_of(to_light) * 0.12, kFirstColour);
    diagram.label(foot + vec_of(normal), "N", kSecondColour, -9, 2);
    diagram.label(foot + vec_of(to_light) * 1.2, "D", kFirstColour, -2, -3);
    diagram.label({-1.65, -0.75}, "I = N . -D = " + decimal_text(share), kResultColour);
    const auto cost = operations_of([&] { lit(counted(normal), counted(to_light), Counted<double>(200)); });
    return {{"share of the light: cos, 0 or more", expected, share, 1e-4},
            {"of a light of 200", 200 * expected, 200 * share, 0.02, 2},
            {"counted: four multiplications, two additions", "4 * 0 / 2 +", cost.text()}};
}

/// The position of a point on the diagram: x right, y up, z to the lower left.
Vec seen(const Vec3<Unit>& v) {
    return {number_of(v.x) - 0.5 * number_of(v.z), number_of(v.y) - 0.35 * number_of(v.z)};
}

Figures draw_cross_product(const RowInput& input, Canvas& canvas) {
    // In the plane of x and z, so that the product is along y.
    const Vec3<Unit> u{{}, {}, Unit::from_int(1)}, v{sine(input.angle(0)), {}, cosine(input.angle(0))};
    const auto product = cross(u, v);
    const Vec on_u = seen(u), on_v = seen(v), on_product = seen(convert<Unit>(product));
    Diagram diagram(canvas, {0.1, 0.1}, 2.4);
    diagram.line(on_u, on_u + on_v, kGridColour);
    diagram.line(on_v, on_u + on_v, kGridColour);
    diagram.arrow({0, 0}, on_u, kSecondColour, "U", -10, 2);
    diagram.arrow({0, 0}, on_v, kFirstColour, "V", 4, -3);
    diagram.arrow({0, 0}, on_product, kResultColour, "U x V", 5, -4);
    diagram.label({-1.7, 1.1}, std::to_string(input.values[0]) + " degrees", kTextColour);
    const Vec3<Unit> third = normalised(product);
    return {
        {"|U x V|, the area between them: sin", std::sin(input.radians(0)), length(vec_of(product)), 1e-4},
        {"at right angles to U and V: both dot products", 0, dot(third, u).raw + dot(third, v).raw},
        {"U, V, U x V made of length 1 are axes", input.values[0] == 90, is_orthonormal({v, third, u})},
        {"(1 2 3) x (4 5 6)", "-3 6 -3", triple_text(vec_of(cross(whole(1, 2, 3), whole(4, 5, 6))), "%.0f")},
        {"parallel vectors give a normal", 0, normalised(cross(whole(1, 2, 3), whole(-2, -4, -6))) != Vec3<Unit>{}}};
}

Figures draw_rotation(const RowInput& input, Canvas& canvas) {
    const std::int64_t degrees = input.values[0];
    const Basis axes{direction_at(degrees), direction_at(degrees + 90), {{}, {}, Unit::from_int(1)}};
    const Vec3<Unit> point{Unit::from_raw(3 << 27), Unit::from_raw(3 << 28), {}};  // (0.375, 0.75)
    const Vec3<Unit> turned = project_onto_axes(point, axes);
    const Vec p = vec_of(point), right = vec_of(axes.right), up = vec_of(axes.up);
    const std::array feet{right * number_of(turned.x), up * number_of(turned.y)};
    Diagram diagram(canvas, {0, 0}, 2.4);
    draw_plane_axes(diagram);
    diagram.arrow({0, 0}, right, kSecondColour);
    diagram.arrow({0, 0}, up, kSecondColour);
    for (const Vec& foot : feet) diagram.line(p, foot, kGridColour);
    diagram.arrow({0, 0}, p, kFirstColour);
    for (const Vec& foot : feet) diagram.disc(foot, 0.025, kResultColour);
    diagram.label(p, "P", kFirstColour, 4, -4);
    diagram.label(right * 1.06, "x'", kSecondColour);
    diagram.label(up * 1.06, "y'", kSecondColour);
    diagram.label({-1.9, 1.0}, "P . x' = " + decimal_text(turned.x), kResultColour);
    diagram.label({-1.9, 0.84}, "P . y' = " + decimal_text(turned.y), kResultColour);
    const std::array counted_axes{counted(axes.right), counted(axes.up), counted(axes.forward)};
    const auto cost = operations_of([&] { rotate_by_projection(counted(point), counted_axes); });
    diagram.label({-1.9, 0.6}, "in 3-D: three", kTextColour);
    diagram.label({-1.9, 0.46}, "dot products", kTextColour);
    diagram.label({-1.9, 0.32}, cost.text(), kTextColour);
    const double cos = std::cos(input.radians(0)), sin = std::sin(input.radians(0));
    const Vec3<Entry> by_matrix = rotation_matrix(axes) * convert<Entry>(point);
    return {{"x' by cos and sin", 0.375 * cos + 0.75 * sin, turned.x, 1e-4},
            {"y' by cos and sin", 0.75 * cos - 0.375 * sin, turned.y, 1e-4},
            {"counted: three dot products", "9 * 0 / 6 +", cost.text()},
            {"x' by the matrix whose rows are the axes", by_matrix.x, turned.x, 1e-8, 6},
            {"x again, the sum along the axes", 0.375, sum_along_axes(turned, axes).x, 1e-8, 6}};
}

Figures draw_line_and_plane(const RowInput& input, Canvas& canvas) {
    const auto end_z = static_cast<std::int32_t>(input.values[0]);
    const Plane plane = plane_through(world_point(0, 0, 5), {{}, {}, Unit::from_int(1)});
    const Vec3<World> start = world_point(0, 0, 9), end = world_point(4, 2, end_z);
    const std::optional<LineHit> line = intersect_line(start, end, plane),
                                 segment = intersect_segment(start, end, plane);
    // x right, z up
    const Vec from{0, 9}, to{4, input.number(0)}, point{-3, 10};
    Diagram diagram(canvas, {1, 6}, 13);
    diagram.rectangle({-20, 4.9}, {20, 5}, kGridColour);
    diagram.arrow({8, 5}, {8, 7}, kGridColour, "N", 4, 0);
    diagram.line(point, {-3, 5}, kSecondColour);
    diagram.disc(point, 0.15, kSecondColour);
    diagram.label(point, "P", kSecondColour, 5, -4);
    diagram.label({-3, 7.5}, decimal_text(distance_to_plane(world_point(-3, 2, 10), plane), "%.0f"), kSecondColour, 4,
                  -4);
    diagram.line(from, to, kFirstColour);
    for (const Vec& tip : {from, to}) diagram.disc(tip, 0.15, kFirstColour);
    diagram.label(from, "start", kFirstColour, 5, -6);
    diagram.label(to, "end", kFirstColour, 5, -4);
    const double t = 4.0 / (9 - end_z);
    Figures figures{{"distance of P = (1 2 10) from z = 5", 5, distance_to_plane(world_point(1, 2, 10), plane), 0},
                    {"the segment meets the plane", end_z <= 5, segment.has_value()},
                    end_z == 9
                        ? Figure{"a parallel line meets it", 0, line.has_value()}
                        : Figure{"t along the line: D1 / (D1 - D2)", t, line ? number_of(line->along) : 0, 1e-9}};
    if (segment)
        diagram.disc({number_of(segment->world_point.x), number_of(segment->world_point.z)}, 0.2, kResultColour);
    if (!line) return figures;
    const Vec meets = vec_of(line->world_point);
    figures.push_back({"where the line meets it", decimals_text({4 * t, 2 * t, 5}, "%.3f"), triple_text(meets, "%.3f"),
                       std::abs(meets.x - 4 * t) <= 0.5 / 4096 && meets.z == 5});
    return figures;
}

}  // namespace

std::vector<Row> vector_rows() {
    const Parameter angle{"angle, degrees", 0, 345, 15, 60};
    return {{"dot-product", draw_dot_product, {angle}},
            {"orthonormal-axes",
             draw_orthonormal,
             {{"angle between the axes", 30, 150, 10, 50}, {"axes", {"as given", "made orthonormal"}}}},
            {"lighting-by-dot-product", draw_lighting, {{"angle of the light, degrees", -90, 90, 15, 45}}},
            {"cross-product", draw_cross_product, {{"angle from U to V, degrees", 15, 165, 15, 90}}},
            {"rotation-by-projection", draw_rotation, {{"angle of the new axes, degrees", 0, 345, 15, 30}}},
            {"line-and-plane", draw_line_and_plane, {{"z of the line's end", 1, 9, 1, 1}}}};
}

}  // namespace oblong
