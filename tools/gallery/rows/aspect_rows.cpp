// Seed 1 (Muratori): the shape of pixels, the field of view, the projection for both and its cost; the dot product
// derived from seven requirements.

#include <array>
#include <cmath>
#include <numbers>

#include "engine/base/table.h"
#include "engine/draw/drawing.h"
#include "engine/fixed/trig.h"
#include "engine/view/project.h"
#include "tools/gallery/counted.h"
#include "tools/gallery/diagram.h"
#include "tools/gallery/row.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

/// A mode and display, with the seed's a = w / (r h) as corrected.
struct NamedMode {
    const char* name;
    ScreenMode mode;
    Ratio a;
};
constexpr std::array<NamedMode, 8> kModes{{{"320x200 on 4:3", {320, 200, {4, 3}}, {6, 5}},
                                           {"640x480 on 4:3", {640, 480, {4, 3}}, {1, 1}},
                                           {"640x480 on 1.85:1", {640, 480, {37, 20}}, {80, 111}},
                                           {"320x240 on 4:3", {320, 240, {4, 3}}, {1, 1}},
                                           {"640x400 on 4:3", {640, 400, {4, 3}}, {6, 5}},
                                           {"1280x1024 on 4:3", {1280, 1024, {4, 3}}, {15, 16}},
                                           {"360x480 on 4:3", {360, 480, {4, 3}}, {9, 16}},
                                           {"320x200 on 8:5", {320, 200, {8, 5}}, {1, 1}}}};

/// The display's outline, with a disc of few pixels, which shows their shape.
Figures draw_pixel_aspect(const RowInput& input, Framebuffer canvas) {
    const NamedMode& named = item(kModes, input.values[0]);
    const double wide = number_of(named.mode.display), shape = number_of(named.mode.pixel());
    Diagram diagram(input, canvas, {0, 0}, 1.12);
    diagram.fill(input.colour(20, 24, 36));
    constexpr int kRows = 15;
    const double high = 1.0 / kRows, across = high * shape;
    const int columns = static_cast<int>(wide / across / 2) + 1;
    for (int row = -kRows / 2; row <= kRows / 2; ++row)
        for (int column = -columns; column <= columns; ++column) {
            const PlanePoint middle{column * across, row * high};
            if (std::abs(middle.x) + across / 2 > wide / 2 + 1e-9) continue;
            const bool is_in_disc = std::hypot(middle.x, middle.y) < 0.4;
            const std::uint8_t colour = is_in_disc ? input.colour(220, 150, 60) : input.colour(44, 54, 76);
            diagram.rectangle({middle.x - across * 0.44, middle.y - high * 0.44},
                              {middle.x + across * 0.44, middle.y + high * 0.44}, colour);
        }
    diagram.circle({0, 0}, 0.4, input.colour(240, 230, 200));
    diagram.outline({-wide / 2, -0.5}, {wide / 2, 0.5}, input.colour(150, 160, 180));
    const double a = number_of(named.a);
    const Projection projection = make_projection(named.mode, Degrees::from_int(90));
    return {number_figure("a = w / (r h): pixel's height to width", a, 1 / shape, 1e-12, 6),
            number_figure("multiplier of y / multiplier of x = 1 / a", 1 / a,
                          number_of(projection.y.multiplier) / number_of(projection.x.multiplier), 1e-8, 6)};
}

constexpr std::array<int, 3> kFieldsOfView{60, 90, 120};
/// The distance of the viewplane for 320 columns, and the field of view from top to bottom on 4:3: the seed's,
/// recomputed.
struct ExpectedView {
    double distance_px, vertical_degrees;
};
constexpr std::array<ExpectedView, 3> kExpectedViews{
    {{277.128129211, 46.826449}, {160, 73.739795}, {92.376043070, 104.821821}}};

/// The seed's figures 1 to 3: the eye, the viewplane at its distance d with its width w, the angle between the sides
/// of the view, and the lines of projection of a cube, from above. Lengths are pixels, 320 across the canvas.
void draw_plan(const ScreenMode& mode, double distance_px, int degrees, const RowInput& input, Framebuffer canvas) {
    if (canvas.width_px < 320 || canvas.height_px < 200) return;
    const double scale = 320.0 / input.mode.width_px, d = distance_px * scale, half = mode.width_px * scale / 2;
    const Framebuffer part = part_of(canvas, {0, 0, canvas.width_px * 130 / 320, canvas.height_px});
    Diagram plan(input, part, {0, 312}, 704);
    const std::uint8_t grey = input.colour(110, 118, 140), blue = input.colour(110, 160, 230),
                       orange = input.colour(230, 160, 70), white = input.colour(235, 235, 225);
    plan.rectangle({-600, -40}, {600, 470}, input.assets.text.dark);
    const std::array<PlanePoint, 4> cube{{{-60, 310}, {60, 310}, {60, 430}, {-60, 430}}};
    for (const PlanePoint corner : cube) plan.line({0, 0}, corner, grey);
    plan.outline(cube, orange);
    for (const double side : {-1.0, 1.0}) plan.line({0, 0}, {side * 455 * half / d, 455}, blue);
    plan.line({-half, d}, {half, d}, white);
    plan.line({0, 0}, {0, d}, white);
    plan.text({half, d}, "w " + std::to_string(mode.width_px), white, -34, -10);
    plan.text({0, d / 2}, "d " + decimal_text(distance_px, "%.1f"), white, 3, -2);
    plan.text({0, 0}, std::to_string(degrees) + " degrees", blue, -64, -2);
}

Figures draw_field_of_view(const RowInput& input, Framebuffer canvas) {
    const auto choice = as_size(input.values[0]);
    const auto divisor = static_cast<std::int32_t>(input.values[1]);
    const ScreenMode mode{std::max(input.mode.width_px / divisor, 40), std::max(input.mode.height_px / divisor, 25),
                          input.mode.display};
    const int degrees = kFieldsOfView[choice];
    std::vector<std::uint8_t> pixels(pixel_count(mode.width_px, mode.height_px));
    DemoFrame(input, mode)
        .draw(camera_at(0, -368, 70, 90, -4, degrees), {pixels.data(), mode.width_px, mode.height_px, mode.width_px});
    enlarge(pixels, mode, canvas);
    const Projection at_320 = make_projection({320, 200, {4, 3}}, Degrees::from_int(degrees));
    const Projection here = make_projection(mode, Degrees::from_int(degrees));
    draw_plan(mode, number_of(here.x.multiplier), degrees, input, canvas);
    const double vertical = 2 * std::atan(100 / number_of(at_320.y.multiplier)) * 180 / std::numbers::pi;
    return {number_figure("distance of the viewplane for 320 columns, pixels", kExpectedViews[choice].distance_px,
                          number_of(at_320.x.multiplier), 1e-6),
            number_figure("field of view from top to bottom, degrees", kExpectedViews[choice].vertical_degrees,
                          vertical, 1e-6),
            number_figure("distance / columns, the same in every mode", kExpectedViews[choice].distance_px / 320,
                          number_of(here.x.multiplier) / mode.width_px, 1e-8, 6)};
}

/// The demo level's sphere, from a distance at which perspective stretches it by less than 1 %.
Camera camera_before_sphere() {
    return camera_at(-112, 352 - 300, 128, 90, 0, 40);
}

/// The operations of the seed's three projections for a point: naive, by the formula at each point, by two multipliers.
struct ProjectionCosts {
    CountedOperations naive, by_formula, by_multipliers;
};
ProjectionCosts projection_costs() {
    using Number = Counted<double>;
    const Vec3<Number> point{3, 2, 7};
    const SeedPixel<Number> centre{160, 100}, size{320, 200};
    return {operations_of([&] { project_naively(point, Number(160), centre); }),
            operations_of([&] { project_by_formula(point, Number(160), Number(4.0 / 3), size, centre); }),
            operations_of([&] {
                project_by_multipliers(point, {160, 400.0 / 3}, centre);
            })};
}

/// The error of the top row with 1.33 instead of 4/3, in 320x200 at 90 degrees, of the point three units up, four
/// ahead.
double error_of_rounded_aspect_px() {
    const auto top = [](Ratio display) {
        const Projection projection = make_projection({320, 200, display}, Degrees::from_int(90));
        return number_of(project({{}, View::from_int(3), View::from_int(4)}, projection).y);
    };
    return top({133, 100}) - top({4, 3});
}

Figures draw_two_multipliers(const RowInput& input, Framebuffer canvas) {
    RowInput square = input;
    square.settings.correct_aspect = input.values[0] == 0;
    DemoFrame(square, input.mode).draw(camera_before_sphere(), canvas);
    const Projection projection = make_projection(input.mode, Degrees::from_int(40), square.settings.correct_aspect);
    // A square of 1 x 1 unit, 4 units away.
    const auto corner = [&](std::int64_t x, std::int64_t y) {
        return project({View::from_int(x), View::from_int(y), View::from_int(4)}, projection);
    };
    const double columns = number_of(corner(1, 0).x - corner(0, 0).x),
                 rows = number_of(corner(0, 0).y - corner(0, 1).y);
    const double shape = number_of(input.mode.pixel());
    const double right_shape = square.settings.correct_aspect ? 1 : shape;
    const ProjectionCosts costs = projection_costs();
    draw_note(canvas,
              std::array<std::string, 4>{"a point costs", "naive        " + costs.naive.text(),
                                         "multipliers  " + costs.by_multipliers.text(),
                                         "formula      " + costs.by_formula.text()},
              input.assets.text);
    return {{"a point by two multipliers, as naive", costs.naive.text(), costs.by_multipliers.text(),
             costs.by_multipliers == costs.naive},
            number_figure("width to height of a square as shown", right_shape, columns / rows * shape, 0.005),
            {"a point by the whole formula", "4 * 3 / 2 +", costs.by_formula.text(),
             costs.by_formula == CountedOperations{4, 3, 2}},
            number_figure("rows that 1.33 for 4/3 is off by, at the top", 100 - 100 * 1.33 / (4.0 / 3),
                          error_of_rounded_aspect_px(), 1.0 / 512),
            measured("multiplier of x, pixels", decimal_text(number_of(projection.x.multiplier))),
            measured("multiplier of y, pixels", decimal_text(number_of(projection.y.multiplier)))};
}

using Dots = std::array<std::array<double, 3>, 3>;

/// The engine's dot products of axes of which the first two enclose this angle.
Dots dots_of_axes(std::int64_t degrees) {
    const Angle angle = degrees_to_angle(Degrees::from_int(degrees));
    constexpr Unit kOne = Unit::from_int(1);
    const std::array<Vec3<Unit>, 3> axes{{{kOne, {}, {}}, {cosine(angle), sine(angle), {}}, {{}, {}, kOne}}};
    Dots dots{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) dots[i][j] = number_of(dot(axes[i], axes[j]));
    return dots;
}

/// The nine terms as a table; zero terms are dim.
void draw_nine_terms(const Vec3<double>& u, const Vec3<double>& v, const Dots& dots, const GalleryAssets& assets,
                     Framebuffer canvas) {
    const std::array us{u.x, u.y, u.z}, vs{v.x, v.y, v.z};
    constexpr std::array kNames{'i', 'j', 'k'};
    const TextColours dim{assets.colour(90, 98, 124), assets.text.dark};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const double product = us[i] * vs[j], axes = dots[i][j];
            const std::string text = decimal_text(product, "%3.0f ") + kNames[i] + "." + kNames[j] +
                                     decimal_text(axes, axes == 0 || axes == 1 ? " =%5.0f" : " =%5.2f");
            draw_text(canvas, kTextMargin_px + static_cast<std::int32_t>(i) * canvas.width_px / 3,
                      canvas.height_px - kFooter_px - 38 + static_cast<std::int32_t>(j) * kLineHeight_px, text,
                      std::abs(axes) < 1e-6 ? dim : assets.text);
        }
}

/// The seed's seven equations, each with both sides' values; their consequence, and its cost.
Figures draw_seven_steps(const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    fill(canvas, assets.colour(20, 24, 36));
    const Vec3<double> u{1, 2, 3}, v{4, -5, 6}, w{2, 1, -1};
    const Dots dots = dots_of_axes(input.values[0]);
    const auto product = [&](const Vec3<double>& a, const Vec3<double>& b) { return dot_by_nine_terms(a, b, dots); };
    // The definition, without a dot product: from the triangle of u, v and u - v, in perpendicular axes.
    const double angle = input.angle(0).bam * std::numbers::pi / 32768;
    const auto squared = [&](const Vec3<double>& a) {
        return std::pow(a.x + a.y * std::cos(angle), 2) + std::pow(a.y * std::sin(angle), 2) + a.z * a.z;
    };
    const double defined = (squared(u) + squared(v) - squared(u - v)) / 2;
    struct Step {
        std::string text;
        double left, right;
    };
    const auto sides = [](double left, double right) {
        return decimal_text(left, "%7.2f") + " " + decimal_text(right, "%7.2f");
    };
    const std::array<Step, 7> steps{
        {{"|u| |v| cos = u . v", defined, product(u, v)},
         {"u = 1i + 2j + 3k: |u|^2", squared(u), product(u, u)},
         {"i.j, j.k, k.i = 0", 0, std::abs(dots[0][1]) + std::abs(dots[1][2]) + std::abs(dots[2][0])},
         {"i.i, j.j, k.k = 1", 3, dots[0][0] + dots[1][1] + dots[2][2]},
         {"v . u = u . v", product(v, u), product(u, v)},
         {"u.(v + w) = u.v + u.w", product(u, v + w), product(u, v) + product(u, w)},
         {"(2u) . v = 2 (u . v)", product(u + u, v), 2 * product(u, v)}}};
    std::vector<std::string> lines;
    int holding = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const bool holds = std::abs(steps[i].left - steps[i].right) < 1e-6;
        holding += holds;
        std::string text = std::to_string(i + 1) + " " + steps[i].text;
        text.resize(27, ' ');
        lines.push_back(text + sides(steps[i].left, steps[i].right) + (holds ? "  yes" : "  no"));
    }
    lines.push_back("");
    lines.push_back("u . v in nine terms:");
    draw_column(canvas, kTextMargin_px, kHeader_px + 5, lines, assets.text);
    if (canvas.height_px >= 200) draw_nine_terms(u, v, dots, assets, canvas);
    using Number = Counted<double>;
    const Vec3<Number> counted_u{u.x, u.y, u.z}, counted_v{v.x, v.y, v.z};
    const std::array<std::array<Number, 3>, 3> some{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
    const CountedOperations three = operations_of([&] { dot_by_components(counted_u, counted_v); }),
                            nine = operations_of([&] { dot_by_nine_terms(counted_u, counted_v, some); });
    const bool is_orthonormal = input.values[0] == 90;
    return {count_figure("of the seven hold", is_orthonormal ? 7 : 6, holding),
            number_figure("nine terms; by lengths of u, v, u - v", defined, product(u, v), 1e-4),
            number_figure("the three terms alone miss by", 3 * std::cos(angle), product(u, v) - dot_by_components(u, v),
                          1e-4),
            measured("three terms cost", three.text()), measured("nine terms cost", nine.text())};
}

}  // namespace

std::vector<Row> aspect_rows() {
    return {{"pixel-aspect", draw_pixel_aspect, {choice_of("mode", kModes)}},
            {"field-of-view",
             draw_field_of_view,
             {choice_parameter("field of view", {"60 degrees", "90 degrees", "120 degrees"}, 1),
              {"pixels divided by", 1, 8, 1, 1}}},
            {"two-multipliers",
             draw_two_multipliers,
             {choice_parameter("pixels are", {"as on the display", "taken for square"})}},
            {"dot-product-steps", draw_seven_steps, {{"degrees from i to j", 60, 120, 10, 90}}}};
}

}  // namespace oblong
