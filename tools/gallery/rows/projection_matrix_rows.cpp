// Projection as a matrix: homogeneous coordinates (seeds 2, 3 and 4), the course notes' matrix with its depth (3), and
// the lab's five steps from the world to the canonical view volume (2).

#include "engine/methods/canonical_volume.h"
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

/// The seed's words.
constexpr std::array<const char*, 5> kSteps{"1 translate VRP", "2 rotate", "3 translate COP", "4 shear", "5 scale"};

/// The lab's cube and window with the VPN turned about the VRP: the COP is no longer straight before the window.
struct TurnedWindow {
    /// The distances of the front and the back plane from the VRP, and of the lab's COP from it.
    static constexpr double kFront = 1, kBack = 4, kCop = 2;
    double sine, cosine;

    WindowView view() const {
        WindowView window = lab_window(kCop, 1);
        window.normal = world_point(-1024 * sine, 0, -1024 * cosine);
        window.front = World::from_int(1);
        window.back = World::from_int(4);
        return window;
    }
    /// VRP'z of the seed: from the COP to the window's plane.
    double distance() const { return kCop * cosine; }
    /// Where the ray through the window's (u, v) is at a depth behind the window. Forward is (sine, 0, cosine), u
    /// (-cosine, 0, sine).
    Vec on_ray(double u, double v, double depth) const {
        const Vec to_window{-u * cosine, v, kCop + u * sine};
        return Vec{0.5, 0.5, -2 - kCop} + to_window * ((distance() + depth) / distance());
    }
};

Vec from_above(const Matrix4& matrix, const Vec& p) {
    const Vec4 at = matrix * homogeneous_of(p);
    return {number_of(at.x), number_of(at.z)};
}

/// A step's picture from above: x right, z up.
void draw_panel(const Matrix4& matrix, const TurnedWindow& window, Diagram& diagram) {
    const Cube cube{{0, 0, 0}, 1};
    draw_edges(
        diagram, [&](int corner) { return from_above(matrix, cube.corner(corner)); }, kOrange);
    const auto at = [&](double u, double depth) { return from_above(matrix, window.on_ray(u, 0, depth)); };
    diagram.line({-9, 0}, {9, 0}, kSteel);
    diagram.line({0, 0}, {0, at(0, TurnedWindow::kBack).y}, kSteel);
    const Vec cop = at(0, -window.distance());
    for (const double side : {-0.5, 0.5}) {
        diagram.line(cop, at(side, TurnedWindow::kFront), kSteel);
        diagram.line(at(side, TurnedWindow::kFront), at(side, TurnedWindow::kBack), kSky);
    }
    for (const double depth : {TurnedWindow::kFront, TurnedWindow::kBack}) {
        const Vec left = at(-0.5, depth), right = at(0.5, depth);
        diagram.line(left, right, kSky);
        diagram.label(left.x > right.x ? left : right, depth == TurnedWindow::kFront ? "F" : "B", kSky, 4);
    }
    diagram.line(at(-0.5, 0), at(0.5, 0), kWhite);
    diagram.label(cop, "COP", kGreen, 4, -8);
}

/// The worst distance of the volume's corners from the canonical volume's.
double worst_corner(const Matrix4& whole, const TurnedWindow& window) {
    double worst = 0;
    for (const double depth : {TurnedWindow::kFront, TurnedWindow::kBack})
        for (const double u : {-1.0, 1.0})
            for (const double v : {-1.0, 1.0}) {
                const double z = (window.distance() + depth) / (window.distance() + TurnedWindow::kBack);
                const Vec4 found = whole * homogeneous_of(window.on_ray(u / 2, v / 2, depth));
                worst = std::max({worst, std::abs(number_of(found.x) - u * z), std::abs(number_of(found.y) - v * z),
                                  std::abs(number_of(found.z) - z)});
            }
    return worst;
}

/// A step's columns of 320, left and right, and the plane's point in the middle of the scene with its height: a panel
/// is its half.
struct Panel {
    int left, right;
    Vec centre;
    double units_high;
};
constexpr std::array<Panel, 5> kPanels{{{0, 106, {0, -2.4}, 15.4},
                                        {107, 213, {0, -2.4}, 15.4},
                                        {214, 320, {0.8, -0.5}, 15.4},
                                        {0, 64, {0, 7.2}, 15.4},
                                        {65, 176, {0, 1.29}, 4.1}}};

Figures draw_volume_steps(const RowInput& input, Canvas& canvas) {
    const TurnedWindow window{std::sin(input.radians(1)), std::cos(input.radians(1))};
    const std::array<Matrix4, 5> steps = lab_volume_steps(window.view());
    const auto chosen = as_size(input.values[0]);
    const std::int32_t middle = (canvas.height_px - kHeader_px - kFooter_px) / 2;
    Matrix4 product = Matrix4::identity();
    for (std::size_t i = 0; i < steps.size(); ++i) {
        product = steps[i] * product;
        const Panel& panel = kPanels[i];
        const std::int32_t left = canvas.width_px * panel.left / 320, right = canvas.width_px * panel.right / 320;
        Diagram diagram(canvas.part({left, 0, right - left, canvas.height_px}), panel.centre, panel.units_high);
        draw_panel(product, window, diagram);
        canvas.write(left + 2, kHeader_px + (i < 3 ? 0 : middle) + 2, kSteps[i],
                     chosen == i ? Rgb8{250, 225, 150} : Rgb8{150, 156, 150});
    }
    std::vector<std::string> lines = matrix_lines(std::string(kSteps[chosen]) + ":", steps[chosen], "%5.2f");
    lines.pop_back();
    canvas.column(canvas.width_px * 178 / 320, middle + 2, lines);

    const double d = window.distance(), back = d + TurnedWindow::kBack;
    const Entry vrp_z = (product * homogeneous_of({0.5, 0.5, -2})).z,
                front_z = (product * homogeneous_of(window.on_ray(0, 0, TurnedWindow::kFront))).z;
    return {{"the volume's corners, from the canonical one's: worst", 0, worst_corner(product, window), 1e-5, 6},
            {"the window's z: d = VRP'z / B'", d / back, vrp_z, 1e-6, 6},
            {"the front's z: F' / B'", (d + TurnedWindow::kFront) / back, front_z, 1e-6, 6},
            {"shear of x: -tan of the VPN's turn", -window.sine / window.cosine, steps[3].rows[0][2], 1e-6, 6},
            {"scale of x: 2 VRP'z / (du B')", 2 * d / back, steps[4].rows[0][0], 1e-6, 6},
            {"scale of z: 1 / B'", 1 / back, steps[4].rows[2][2], 1e-6, 6}};
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
            {"volume-steps",
             draw_volume_steps,
             {{"step", {kSteps.begin(), kSteps.end()}}, {"VPN turned, degrees", -30, 30, 10, 20}}}};
}

}  // namespace oblong
