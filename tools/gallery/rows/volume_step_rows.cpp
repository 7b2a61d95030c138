// Seed 2 (the lab): from the world to the canonical view volume in five steps, with their matrices.

#include "engine/methods/canonical_volume.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

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

std::vector<Row> volume_step_rows() {
    return {{"volume-steps",
             draw_volume_steps,
             {{"step", {kSteps.begin(), kSteps.end()}}, {"VPN turned, degrees", -30, 30, 10, 20}}}};
}

}  // namespace oblong
