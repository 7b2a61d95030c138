// Projection as a matrix: homogeneous coordinates (seeds 2, 3 and 4), the course notes' matrix with its depth (3), and
// an OpenGL polygon in the pipeline (4).

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/math/vec.h"
#include "engine/methods/canonical_volume.h"
#include "engine/methods/lines.h"
#include "engine/methods/transforms.h"
#include "tools/gallery/row.h"
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
Figures draw_homogeneous(const RowInput& input, Framebuffer canvas) {
    const double sign = input.values[0] == 0 ? 1 : -1, distance = input.number(1) * (input.values[0] == 1 ? -1 : 1);
    Diagram diagram(input, canvas, {2.5, 1.1}, 8);
    diagram.fill(input.colour(18, 22, 34));
    const std::uint8_t grey = input.colour(110, 118, 140), bright = input.colour(240, 190, 90),
                       blue = input.colour(90, 130, 220);
    diagram.line({-4.4, 0}, {9, 0}, grey);
    diagram.line({sign * distance, -2.4}, {sign * distance, 3.6}, blue);
    diagram.text({sign * distance, -1.9}, "z = " + decimal_text(distance, "%.0f"), blue);
    diagram.text({0, 0}, "eye", grey, -4, 4);
    double found = 0;
    for (const double ahead : {3.0, 5.0, 8.0}) {
        const Vec4 clip = perspective(distance) * Vec4{entry_of(0), entry_of(3), entry_of(sign * ahead)};
        const Vec3<Entry> point = *point_of(clip);
        const PlanePoint picture{sign * number_of(point.z), number_of(point.y)};
        diagram.line(picture, {ahead, 3}, grey);
        diagram.line({0, 0}, {ahead, 3}, grey);
        diagram.disc({ahead, 3}, 0.09, bright);
        diagram.disc(picture, 0.09, input.colour(110, 200, 110));
        diagram.text({ahead, 3}, "w " + decimal_text(number_of(clip.w), "%.2f"), bright, -12, -12);
        found = number_of(point.y);
    }
    const auto x_of = [](double d, double x, double z) {
        return number_of(point_of(perspective(d) * Vec4{entry_of(x), Entry{}, entry_of(z)})->x);
    };
    const Matrix4 move = translation({entry_of(5), {}, {}});
    const Vec4 direction = move * Vec4{entry_of(1), {}, {}, {}}, point = move * Vec4{entry_of(1), {}, {}};
    const auto halved = *point_of({entry_of(2), entry_of(-4), entry_of(6), entry_of(2)});
    return {number_figure("y of (0, 3, z, 1) on the viewplane: 3 D / z", 3 * distance / (sign * 8), found, 1e-8),
            number_figure("x of (1, 0, -2) with D = -1", 0.5, x_of(-1, 1, -2), 1e-8),
            number_figure("x of (1, 0, -2) with D = 1, as listed: mirrored", -0.5, x_of(1, 1, -2), 1e-8),
            number_figure("x of the point (1, 0, 0, 1) moved by 5", 6, number_of(point.x), 0),
            number_figure("x of the direction (1, 0, 0, 0) moved by 5", 1, number_of(direction.x), 0),
            number_figure("y of (2, -4, 6, 2) as a point", -2, number_of(halved.y), 0)};
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

double depth_of(const Matrix4& matrix, double z) {
    return number_of(point_of(matrix * Vec4{Entry{}, Entry{}, entry_of(z)})->z);
}

/// Depth as a function of z, from the near to the far plane.
void draw_depths(const std::array<const Matrix4*, 2>& matrices, double nearest, double farthest, const RowInput& input,
                 Framebuffer canvas) {
    const std::int32_t left = canvas.width_px * 200 / 320;
    Diagram diagram(input, part_of(canvas, {left, 0, canvas.width_px - left, canvas.height_px}), {0.36, 0.5}, 1.5);
    const std::uint8_t grey = input.colour(90, 98, 124);
    const std::array<std::uint8_t, 2> colours{input.colour(220, 70, 60), input.colour(110, 220, 120)};
    constexpr double kWide = 0.75;
    diagram.line({0, 0}, {kWide, 0}, grey);
    diagram.line({0, 1}, {kWide, 1}, grey);
    diagram.line({kWide * nearest / farthest, -0.05}, {kWide * nearest / farthest, 1}, grey);
    diagram.line({kWide, -0.05}, {kWide, 1}, grey);
    diagram.text({0, 1}, "depth 1", grey, 2, -10);
    diagram.text({kWide * nearest / farthest, 0}, "near", grey, -4, 6);
    diagram.text({kWide, 0}, "far", grey, -12, 6);
    for (std::size_t which = 0; which < 2; ++which) {
        const auto place = [&](int part) {
            const double z = nearest + (farthest - nearest) * std::pow(part / 96.0, 3);
            return PlanePoint{kWide * z / farthest, depth_of(*matrices[which], z)};
        };
        diagram.curve(96, place, colours[which]);
    }
}

Figures draw_projection_matrix(const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    fill(canvas, assets.colour(18, 22, 34));
    const bool is_listed = input.values[0] == 1;
    const double nearest = input.number(1) / 10, farthest = input.number(2);
    const Matrix4 corrected = volume_matrix(make_projection({320, 200, {4, 3}}, Degrees::from_int(90)),
                                            entry_of(nearest), entry_of(farthest)),
                  listed = listed_matrix(nearest, farthest);
    const Matrix4& shown = is_listed ? listed : corrected;
    draw_depths({&listed, &corrected}, nearest, farthest, input, canvas);
    std::vector<std::string> lines{is_listed ? "as listed (red)" : "corrected (green)", ""};
    for (const auto& row : shown.rows) lines.push_back(row_text(row, "%6.3f"));
    lines.insert(lines.end(),
                 {"", std::string("a = ") + (is_listed ? "4/3, width / height" : "3/4, height / width"),
                  "f = 4/3, 1 / tan(fov / 2)", "lambda = " + decimal_text(number_of(shown.rows[2][2]), "%.6f")});
    draw_column(canvas, kTextMargin_px, kHeader_px + 6, lines, assets.text);

    // A point 45 degrees to the right is on the view's right edge, since the view is 90 degrees wide.
    const double edge = number_of(point_of(shown * Vec4{entry_of(2), Entry{}, entry_of(2)})->x);
    const double lambda = farthest / (farthest - nearest);
    const double harmonic = 2 * nearest * farthest / (nearest + farthest);
    return {
        number_figure("depth of the far plane", is_listed ? 1 - nearest : 1, depth_of(shown, farthest), 1e-6, 6),
        number_figure("depth of the near plane", 0, depth_of(shown, nearest), 1e-6, 6),
        number_figure("right edge of the view: x", is_listed ? 16.0 / 9 : 1, edge, 1e-8, 6),
        number_figure("lambda", is_listed ? lambda - lambda * nearest : lambda, number_of(shown.rows[2][2]), 1e-8, 6),
        number_figure("depth at 2 n f / (n + f)", is_listed ? (1 - nearest) / 2 : 0.5, depth_of(shown, harmonic), 1e-6,
                      6)};
}

constexpr std::array<Vec, 4> kQuad{{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 1}}};
constexpr Vec kQuadTarget{0.5, 0.5, 0.5};
constexpr int kQuadView = 32;

/// OpenGL's axes, x right, y up, z toward the viewer, in the engine's: x east, y north, z up.
Vec3<World> from_gl(const Vec& p) {
    return world_point(p.x, -p.z, p.y);
}

/// A point's position in a part of the picture, in doubles.
PlanePoint pixel_in_double(const Vec& p, const Vec& eye, const RowInput& input, const Area& area) {
    const Vec forward = normalised(kQuadTarget - eye), right = normalised(cross(forward, {0, 1, 0})),
              up = cross(right, forward), way = p - eye;
    const double shape = number_of(input.mode.pixel());
    const double d = area.width / 2.0 / std::tan(kQuadView * std::numbers::pi / 360);
    return {area.width / 2.0 + d * dot(way, right) / dot(way, forward),
            area.height / 2.0 - d * shape * dot(way, up) / dot(way, forward)};
}

Figures draw_opengl_quad(const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    fill(canvas, assets.colour(18, 22, 34));
    const double turn = input.radians(0);
    const Vec eye{0.5 + 4 * std::sin(turn), 1.6, 0.5 + 4 * std::cos(turn)};
    const Area area = scene_area(canvas, 180);
    Sketch sketch(input, canvas, area, {from_gl(eye), from_gl(kQuadTarget), kQuadView});
    std::array<Vec3<World>, 4> corners;
    std::transform(kQuad.begin(), kQuad.end(), corners.begin(), from_gl);
    const std::uint8_t fill = assets.colour(200, 150, 60);
    sketch.polygon(corners, fill);
    std::int64_t pixels = 0;
    const Area shown = clipped(area, canvas);
    for (std::int32_t y = shown.y; y < shown.y + shown.height; ++y)
        pixels += std::count(canvas.row(y), canvas.row(y) + shown.width, fill);
    sketch.outline(corners, assets.colour(250, 225, 150));
    sketch.axes({from_gl({1.3, 0, 0}), from_gl({0, 1.3, 0}), from_gl({0, 0, 1.3})}, assets);
    double worst_px = 0, shoelace = 0;
    std::vector<std::string> lines{"glBegin(GL_POLYGON)"};
    for (std::size_t i = 0; i < 4; ++i) {
        const PlanePoint expected = pixel_in_double(kQuad[i], eye, input, area),
                         next = pixel_in_double(kQuad[(i + 1) % 4], eye, input, area);
        const PlanePoint found = sketch.place_of(corners[i]).value_or(PlanePoint{-1, -1});
        worst_px = std::max(worst_px, std::hypot(found.x - expected.x, found.y - expected.y));
        shoelace += (expected.x * next.y - next.x * expected.y) / 2;
        const Vec& p = kQuad[i];
        lines.push_back("glVertex3f(" + decimals_text({p.x, p.y, p.z}, "%.0f", ", ") + ")");
        const Vec3<World>& w = corners[i];
        const Vec3<Entry> divided = *point_of(sketch.world_to_volume() * homogeneous(w));
        lines.push_back(decimals_text({number_of(divided.x), number_of(divided.y)}, "%6.3f") +
                        decimal_text(number_of(divided.z), " %6.4f"));
        lines.push_back("  " + decimal_text(found.x, "%7.2f") + decimal_text(found.y, "%8.2f"));
    }
    lines.push_back("glEnd()");
    draw_column(canvas, canvas.width_px * 186 / 320, kHeader_px + 8, lines, assets.text);

    const Vec3<Unit> normal = normalised(oblong::cross(corners[1] - corners[0], corners[3] - corners[0]));
    const Plane plane = plane_through(corners[0], normal);
    const auto doubled = oblong::cross(corners[2] - corners[0], corners[3] - corners[1]);  // of its diagonals
    return {number_figure("area of the polygon: root 2", std::numbers::sqrt2,
                          std::hypot(number_of(doubled.x), number_of(doubled.y), number_of(doubled.z)) / 2, 1e-9, 6),
            number_figure("its fourth corner's distance from the others' plane", 0,
                          number_of(distance_to_plane(corners[2], plane)), 1e-6, 6),
            number_figure("pixels from the closed form: worst corner", 0, worst_px,
                          0.01 * std::max({1.0, area.width / 180.0, area.height / 154.0})),
            number_figure("pixels drawn: the area of its picture", std::abs(shoelace), static_cast<double>(pixels),
                          static_cast<double>(area.width + area.height) / 16, 0)};
}

}  // namespace

std::vector<Row> projection_matrix_rows() {
    return {
        {"homogeneous",
         draw_homogeneous,
         {choice_parameter("axes", {"z ahead, D > 0", "looking down -z, D < 0", "looking down -z, D > 0 as listed"}),
          {"distance of the viewplane", 1, 4, 1, 2}}},
        {"projection-matrix",
         draw_projection_matrix,
         {choice_parameter("matrix", {"corrected", "as listed"}),
          {"near, tenths", 1, 20, 1, 5},
          {"far", 5, 100, 5, 10}}},
        {"opengl-quad", draw_opengl_quad, {{"seen from, degrees", -60, 60, 10, 30}}}};
}

}  // namespace oblong
