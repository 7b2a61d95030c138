// Projection as a matrix: homogeneous coordinates (seeds 2, 3 and 4), the course notes' matrix with its depth (3), and
// an OpenGL polygon in the pipeline (4).

#include "engine/methods/canonical_volume.h"
#include "engine/methods/lines.h"
#include "engine/methods/transforms.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

/// (x, y, z, 1) to (x, y, z, z / d).
Matrix4 perspective(double distance) {
    Matrix4 matrix = Matrix4::identity();
    matrix.rows[3] = {Entry{}, Entry{}, entry_of(1 / distance), Entry{}};
    return matrix;
}

/// Points and directions in four coordinates, in a side view: z to the right, y up. By seed 4's convention z grows
/// toward the viewer; with D above 0, as listed, the picture plane is behind the eye and the picture is upside down.
Figures draw_homogeneous(const RowInput& input, Canvas& canvas) {
    const double sign = input.values[0] == 0 ? 1 : -1, distance = input.number(1) * (input.values[0] == 1 ? -1 : 1);
    Diagram diagram(canvas, {2.5, 1.1}, 8);
    diagram.line({-4.4, 0}, {9, 0}, kGrey);
    diagram.line({sign * distance, -2.4}, {sign * distance, 3.6}, kBlue);
    diagram.label({sign * distance, -1.9}, "z = " + decimal_text(distance, "%.0f"), kBlue);
    diagram.label({0, 0}, "eye", kGrey, -4, 4);
    Entry found;
    for (const double ahead : {3.0, 5.0, 8.0}) {
        const Vec4 clip = perspective(distance) * homogeneous_of({0, 3, sign * ahead});
        const Vec3<Entry> point = *point_of(clip);
        const Vec picture{sign * number_of(point.z), number_of(point.y)};
        diagram.line(picture, {ahead, 3}, kGrey);
        diagram.line({0, 0}, {ahead, 3}, kGrey);
        diagram.disc({ahead, 3}, 0.09, kOrange);
        diagram.disc(picture, 0.09, kGreen);
        diagram.label({ahead, 3}, "w " + decimal_text(clip.w, "%.2f"), kOrange, -12, -12);
        found = point.y;
    }
    const auto x_seen = [](double d) { return point_of(perspective(d) * homogeneous_of({1, 0, -2}))->x; };
    const Matrix4 move = translation(entries_of({5, 0, 0}));
    return {{"y of (0, 3, z, 1) on the viewplane: 3 D / z", 3 * distance / (sign * 8), found, 1e-8},
            {"x of (1, 0, -2) with D = -1", 0.5, x_seen(-1), 1e-8},
            {"x of (1, 0, -2) with D = 1, as listed: mirrored", -0.5, x_seen(1), 1e-8},
            {"x of the point (1, 0, 0, 1) moved by 5", 6, (move * homogeneous_of({1, 0, 0})).x, 0},
            {"x of the direction (1, 0, 0, 0) moved by 5", 1, (move * homogeneous_of({1, 0, 0}, 0)).x, 0},
            {"y of (2, -4, 6, 2) as a point", -2, point_of(homogeneous_of({2, -4, 6}, 2))->y, 0}};
}

/// The course notes' view: 90 degrees across a display of 4:3.
constexpr double kAspect = 3.0 / 4;

/// As listed: a = width / height, and a lambda that includes the offset.
Matrix4 listed_matrix(double nearest, double farthest) {
    const double f = 1 / kAspect;
    const double lambda = farthest / (farthest - nearest) - farthest * nearest / (farthest - nearest);
    Matrix4 matrix;
    matrix.rows[0][0] = entry_of(f / kAspect);
    matrix.rows[1][1] = entry_of(f);
    matrix.rows[2] = {Entry{}, Entry{}, entry_of(lambda), entry_of(-lambda * nearest)};
    matrix.rows[3][2] = Entry::from_int(1);
    return matrix;
}

Entry depth_of(const Matrix4& matrix, double z) {
    return point_of(matrix * homogeneous_of({0, 0, z}))->z;
}

/// Depth as a function of z, from the near to the far plane.
void draw_depths(const std::array<const Matrix4*, 2>& matrices, double nearest, double farthest, const Canvas& canvas) {
    const std::int32_t left = canvas.width_px * 200 / 320;
    Diagram diagram(canvas.part({left, 0, canvas.width_px - left, canvas.height_px}), {0.36, 0.5}, 1.5);
    constexpr double kWide = 0.75;
    const double near = kWide * nearest / farthest;
    for (const double depth : {0.0, 1.0}) diagram.line({0, depth}, {kWide, depth}, kFaint);
    for (const double z : {near, kWide}) diagram.line({z, -0.05}, {z, 1}, kFaint);
    diagram.label({0, 1}, "depth 1", kFaint, 2, -10);
    diagram.label({near, 0}, "near", kFaint, -4, 6);
    diagram.label({kWide, 0}, "far", kFaint, -12, 6);
    for (std::size_t which = 0; which < 2; ++which) {
        const auto place = [&](int part) {
            const double z = nearest + (farthest - nearest) * std::pow(part / 96.0, 3);
            return Vec{kWide * z / farthest, number_of(depth_of(*matrices[which], z))};
        };
        diagram.curve(96, place, which == 0 ? kRed : kGreen);
    }
}

Figures draw_projection_matrix(const RowInput& input, Canvas& canvas) {
    const bool is_listed = input.values[0] == 1;
    const double nearest = input.number(1) / 10, farthest = input.number(2);
    const Matrix4 corrected = volume_matrix(make_projection({320, 200, {4, 3}}, Degrees::from_int(90)),
                                            entry_of(nearest), entry_of(farthest)),
                  listed = listed_matrix(nearest, farthest);
    const Matrix4& shown = is_listed ? listed : corrected;
    draw_depths({&listed, &corrected}, nearest, farthest, canvas);
    std::vector<std::string> lines = matrix_lines(is_listed ? "as listed (red)" : "corrected (green)", shown, "%6.3f");
    lines.insert(lines.begin() + 1, "");
    lines.insert(lines.end(), {"", is_listed ? "a = 4/3, width / height" : "a = 3/4, height / width",
                               "f = 4/3, 1 / tan(fov / 2)", "lambda = " + decimal_text(shown.rows[2][2], "%.6f")});
    canvas.column(kTextMargin_px, 6, lines);

    const double lambda = farthest / (farthest - nearest), scale = is_listed ? 1 - nearest : 1;
    // A point 45 degrees to the right is on the view's right edge, since the view is 90 degrees wide.
    return {{"depth of the far plane", scale, depth_of(shown, farthest), 1e-6, 6},
            {"depth of the near plane", 0, depth_of(shown, nearest), 1e-6, 6},
            {"right edge of the view: x", is_listed ? 16.0 / 9 : 1, point_of(shown * homogeneous_of({2, 0, 2}))->x,
             1e-8, 6},
            {"lambda", lambda * scale, shown.rows[2][2], 1e-8, 6},
            {"depth at 2 n f / (n + f)", scale / 2, depth_of(shown, 2 * nearest * farthest / (nearest + farthest)),
             1e-6, 6}};
}

constexpr std::array<Vec, 4> kQuad{{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 1}}};
constexpr Vec kQuadTarget{0.5, 0.5, 0.5};
constexpr int kQuadView = 32;

/// OpenGL's axes, x right, y up, z toward the viewer, in the engine's: x east, y north, z up.
Vec from_gl(const Vec& p) {
    return {p.x, -p.z, p.y};
}

/// A point's position in a part of the picture, in doubles.
Vec pixel_in_double(const Vec& p, const Vec& eye, const RowInput& input, const Area& area) {
    const Vec forward = normalised(kQuadTarget - eye), right = normalised(cross(forward, {0, 1, 0})),
              up = cross(right, forward), way = p - eye;
    const double d = area.width / 2.0 / std::tan(kQuadView * std::numbers::pi / 360);
    return {area.width / 2.0 + d * dot(way, right) / dot(way, forward),
            area.height / 2.0 - d * number_of(input.mode.pixel()) * dot(way, up) / dot(way, forward)};
}

Figures draw_opengl_quad(const RowInput& input, Canvas& canvas) {
    const double turn = input.radians(0);
    const Vec eye{0.5 + 4 * std::sin(turn), 1.6, 0.5 + 4 * std::cos(turn)};
    const Area area = canvas.scene(180);
    Sketch sketch(canvas, area, {from_gl(eye), from_gl(kQuadTarget), kQuadView});
    std::array<Vec, 4> corners;
    std::transform(kQuad.begin(), kQuad.end(), corners.begin(), from_gl);
    sketch.polygon(corners, kAmber);
    std::int64_t pixels = 0;
    for (std::int32_t y = 0; y < sketch.height_px; ++y)
        pixels += std::count(sketch.row(y), sketch.row(y) + sketch.width_px, input.colour(kAmber));
    sketch.outline(corners, kGold);
    sketch.axes({from_gl({1.3, 0, 0}), from_gl({0, 1.3, 0}), from_gl({0, 0, 1.3})});
    double worst_px = 0, shoelace = 0;
    std::vector<std::string> lines{"glBegin(GL_POLYGON)"};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec expected = pixel_in_double(kQuad[i], eye, input, area),
                  next = pixel_in_double(kQuad[(i + 1) % 4], eye, input, area), found = sketch.pixel_of(corners[i]);
        worst_px = std::max(worst_px, std::hypot(found.x - expected.x, found.y - expected.y));
        shoelace += cross(expected, next).z / 2;
        lines.push_back("glVertex3f(" + triple_text(kQuad[i], "%.0f", ", ") + ")");
        const Vec3<Entry> divided = *point_of(sketch.world_to_volume() * homogeneous(world_point(corners[i])));
        lines.push_back(decimals_text({divided.x, divided.y}, "%6.3f") + decimal_text(divided.z, " %6.4f"));
        lines.push_back("  " + decimal_text(found.x, "%7.2f") + decimal_text(found.y, "%8.2f"));
    }
    lines.push_back("glEnd()");
    canvas.column(canvas.width_px * 186 / 320, 8, lines);

    std::array<Vec3<World>, 4> quad;
    std::transform(corners.begin(), corners.end(), quad.begin(), [](const Vec& p) { return world_point(p); });
    const Plane plane = plane_through(quad[0], normalised(cross(quad[1] - quad[0], quad[3] - quad[0])));
    return {
        {"area of the polygon: root 2", std::numbers::sqrt2,  // by its diagonals
         length(vec_of(cross(quad[2] - quad[0], quad[3] - quad[1]))) / 2, 1e-9, 6},
        {"its fourth corner's distance from the others' plane", 0, distance_to_plane(quad[2], plane), 1e-6, 6},
        {"pixels from the closed form: worst corner", 0, worst_px,
         0.01 * std::max({1.0, area.width / 180.0, area.height / 154.0})},
        {"pixels drawn: the area of its picture", std::abs(shoelace), pixels, (area.width + area.height) / 16.0, 0}};
}

}  // namespace

std::vector<Row> projection_matrix_rows() {
    return {{"homogeneous",
             draw_homogeneous,
             {{"axes", {"z ahead, D > 0", "looking down -z, D < 0", "looking down -z, D > 0 as listed"}},
              {"distance of the viewplane", 1, 4, 1, 2}}},
            {"projection-matrix",
             draw_projection_matrix,
             {{"matrix", {"corrected", "as listed"}}, {"near, tenths", 1, 20, 1, 5}, {"far", 5, 100, 5, 10}}},
            {"opengl-quad", draw_opengl_quad, {{"seen from, degrees", -60, 60, 10, 30}}}};
}

}  // namespace oblong
