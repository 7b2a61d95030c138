// Seed 1 (Muratori): the shape of pixels, the field of view, the projection for both and its cost; the dot product
// derived from seven requirements.

#include "engine/view/project.h"
#include "tools/gallery/counted.h"
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
Figures draw_pixel_aspect(const RowInput& input, Canvas& canvas) {
    const NamedMode& named = item(kModes, input.values[0]);
    const double wide = number_of(named.mode.display), shape = number_of(named.mode.pixel());
    Diagram diagram(canvas, {0, 0}, 1.12);
    constexpr int kRows = 15;
    const double high = 1.0 / kRows, across = high * shape;
    const int columns = static_cast<int>(wide / across / 2) + 1;
    for (int row = -kRows / 2; row <= kRows / 2; ++row)
        for (int column = -columns; column <= columns; ++column) {
            const Vec middle{column * across, row * high}, part{across * 0.44, high * 0.44};
            if (std::abs(middle.x) + across / 2 > wide / 2 + 1e-9) continue;
            diagram.rectangle(middle - part, middle + part, std::hypot(middle.x, middle.y) < 0.4 ? kAmber : kShadow);
        }
    diagram.circle({0, 0}, 0.4, kCream);
    diagram.outline(box_of({-wide / 2, -0.5}, {wide / 2, 0.5}), kPale);
    const double a = number_of(named.a);
    const Projection projection = make_projection(named.mode, Degrees::from_int(90));
    return {{"a = w / (r h): pixel's height to width", a, 1 / shape, 1e-12, 6},
            {"multiplier of y / multiplier of x = 1 / a", 1 / a,
             number_of(projection.y.multiplier) / number_of(projection.x.multiplier), 1e-8, 6}};
}

/// A field of view; the distance of the viewplane for 320 columns, and the field of view from top to bottom on 4:3: the
/// seed's, recomputed.
struct ExpectedView {
    const char* name;
    int degrees;
    double distance_px, vertical_degrees;
};
constexpr std::array<ExpectedView, 3> kViews{{{"60 degrees", 60, 277.128129211, 46.826449},
                                              {"90 degrees", 90, 160, 73.739795},
                                              {"120 degrees", 120, 92.376043070, 104.821821}}};

/// The seed's figures 1 to 3: the eye, the viewplane at its distance d with its width w, the angle between the sides
/// of the view, and the lines of projection of a cube, from above. Lengths are pixels, 320 across the canvas.
void draw_plan(std::int32_t width_px, double distance_px, int degrees, const Canvas& canvas) {
    if (canvas.width_px < 320 || canvas.height_px < 200) return;
    const double scale = 320.0 / canvas.input.mode.width_px, d = distance_px * scale, half = width_px * scale / 2;
    Diagram plan(canvas.part({0, 0, canvas.width_px * 130 / 320, canvas.height_px}), {0, 312}, 704);
    plan.rectangle({-600, -40}, {600, 470}, kBlack);
    const std::array cube = box_of({-60, 310}, {60, 430});
    for (const Vec& corner : cube) plan.line({0, 0}, corner, kGrey);
    plan.outline(cube, kOrange);
    for (const double side : {-1.0, 1.0}) plan.line({0, 0}, {side * 455 * half / d, 455}, kSky);
    plan.line({-half, d}, {half, d}, kWhite);
    plan.line({0, 0}, {0, d}, kWhite);
    plan.label({half, d}, "w " + std::to_string(width_px), kWhite, -34, -10);
    plan.label({0, d / 2}, "d " + decimal_text(distance_px, "%.1f"), kWhite, 3, -2);
    plan.label({0, 0}, std::to_string(degrees) + " degrees", kSky, -64, -2);
}

Figures draw_field_of_view(const RowInput& input, Canvas& canvas) {
    const ExpectedView& expected = item(kViews, input.values[0]);
    const auto divisor = static_cast<std::int32_t>(input.values[1]);
    const ScreenMode mode{std::max(input.mode.width_px / divisor, 40), std::max(input.mode.height_px / divisor, 25),
                          input.mode.display};
    const SidePicture picture(mode.width_px, mode.height_px);
    DemoFrame(input, mode).draw(camera_at(0, -368, 70, 90, -4, expected.degrees), picture);
    canvas.enlarge(picture);
    const Projection at_320 = make_projection({320, 200, {4, 3}}, Degrees::from_int(expected.degrees));
    const double here_px = number_of(make_projection(mode, Degrees::from_int(expected.degrees)).x.multiplier);
    draw_plan(mode.width_px, here_px, expected.degrees, canvas);
    return {
        {"distance of the viewplane for 320 columns, pixels", expected.distance_px, at_320.x.multiplier, 1e-6},
        {"field of view from top to bottom, degrees", expected.vertical_degrees,
         2 * std::atan(100 / number_of(at_320.y.multiplier)) / kDegree, 1e-6},
        {"distance / columns, the same in every mode", expected.distance_px / 320, here_px / mode.width_px, 1e-8, 6}};
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

Figures draw_two_multipliers(const RowInput& input, Canvas& canvas) {
    RowInput square = input;
    square.settings.correct_aspect = input.values[0] == 0;
    // The demo level's sphere, from a distance at which perspective stretches it by less than 1 %.
    DemoFrame(square, input.mode).draw(camera_at(-112, 352 - 300, 128, 90, 0, 40), canvas);
    const Projection projection = make_projection(input.mode, Degrees::from_int(40), square.settings.correct_aspect);
    // A square of 1 x 1 unit, 4 units away.
    const auto corner = [&](std::int64_t x, std::int64_t y) {
        return project({View::from_int(x), View::from_int(y), View::from_int(4)}, projection);
    };
    const double columns = number_of(corner(1, 0).x - corner(0, 0).x),
                 rows = number_of(corner(0, 0).y - corner(0, 1).y), shape = number_of(input.mode.pixel());
    // The operations of the seed's three projections for a point.
    using Counting = Counted<double>;
    const Vec3<Counting> point{3, 2, 7};
    const SeedPixel<Counting> centre{160, 100}, size{320, 200}, multipliers{160, 400.0 / 3};
    const auto naive = operations_of([&] { project_naively(point, Counting(160), centre); }),
               by_multipliers = operations_of([&] { project_by_multipliers(point, multipliers, centre); }),
               by_formula =
                   operations_of([&] { project_by_formula(point, Counting(160), Counting(4.0 / 3), size, centre); });
    canvas.note(std::array<std::string, 4>{"a point costs", "naive        " + naive.text(),
                                           "multipliers  " + by_multipliers.text(),
                                           "formula      " + by_formula.text()});
    return {{"a point by two multipliers, as naive", naive.text(), by_multipliers.text()},
            {"width to height of a square as shown", square.settings.correct_aspect ? 1 : shape, columns / rows * shape,
             0.005},
            {"a point by the whole formula", "4 * 3 / 2 +", by_formula.text()},
            {"rows that 1.33 for 4/3 is off by, at the top", 100 - 100 * 1.33 / (4.0 / 3), error_of_rounded_aspect_px(),
             1.0 / 512},
            {"multiplier of x, pixels", decimal_text(projection.x.multiplier)},
            {"multiplier of y, pixels", decimal_text(projection.y.multiplier)}};
}

using Dots = std::array<std::array<double, 3>, 3>;

/// The engine's dot products of axes of which the first two enclose this angle.
Dots dots_of_axes(Angle angle) {
    constexpr Unit kOne = Unit::from_int(1);
    const std::array<Vec3<Unit>, 3> axes{{{kOne, {}, {}}, {cosine(angle), sine(angle), {}}, {{}, {}, kOne}}};
    Dots dots{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) dots[i][j] = number_of(dot(axes[i], axes[j]));
    return dots;
}

/// The nine terms as a table; zero terms are dim.
void draw_nine_terms(const Vec& u, const Vec& v, const Dots& dots, Canvas& canvas) {
    constexpr std::array kNames{'i', 'j', 'k'};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const double axes = dots[i][j];
            const std::string text = decimal_text(u[i] * v[j], "%3.0f ") + kNames[i] + "." + kNames[j] +
                                     decimal_text(axes, axes == 0 || axes == 1 ? " =%5.0f" : " =%5.2f");
            canvas.write(kTextMargin_px + static_cast<std::int32_t>(i) * canvas.width_px / 3,
                         canvas.height_px - kFooter_px - 38 + static_cast<std::int32_t>(j) * kLineHeight_px, text,
                         std::abs(axes) < 1e-6 ? kFaint : kBright);
        }
}

/// An equation of the seed, with the values of both sides.
struct SeedStep {
    std::string text;
    double left, right;
};

/// The seed's seven equations, each with both sides' values; their consequence, and its cost.
Figures draw_seven_steps(const RowInput& input, Canvas& canvas) {
    const Vec u{1, 2, 3}, v{4, -5, 6}, w{2, 1, -1};
    const Dots dots = dots_of_axes(input.angle(0));
    const auto product = [&](const Vec& a, const Vec& b) { return dot_by_nine_terms(a, b, dots); };
    // The definition, without a dot product: from the triangle of u, v and u - v, in perpendicular axes.
    const double angle = input.angle(0).bam * std::numbers::pi / 32768;
    const auto squared = [&](const Vec& a) {
        return std::pow(a.x + a.y * std::cos(angle), 2) + std::pow(a.y * std::sin(angle), 2) + a.z * a.z;
    };
    const double defined = (squared(u) + squared(v) - squared(u - v)) / 2;
    const std::array<SeedStep, 7> steps{
        {{"|u| |v| cos = u . v", defined, product(u, v)},
         {"u = 1i + 2j + 3k: |u|^2", squared(u), product(u, u)},
         {"i.j, j.k, k.i = 0", 0, std::abs(dots[0][1]) + std::abs(dots[1][2]) + std::abs(dots[2][0])},
         {"i.i, j.j, k.k = 1", 3, dots[0][0] + dots[1][1] + dots[2][2]},
         {"v . u = u . v", product(v, u), product(u, v)},
         {"u.(v + w) = u.v + u.w", product(u, v + w), product(u, v) + product(u, w)},
         {"(2u) . v = 2 (u . v)", product(u + u, v), 2 * product(u, v)}}};
    std::vector<std::string> lines;
    int holding = 0;
    for (const SeedStep& step : steps) {
        const bool holds = std::abs(step.left - step.right) < 1e-6;
        holding += holds;
        std::string text = std::to_string(lines.size() + 1) + " " + step.text;
        text.resize(27, ' ');
        lines.push_back(text + decimals_text({step.left, step.right}, "%7.2f") + (holds ? "  yes" : "  no"));
    }
    lines.insert(lines.end(), {"", "u . v in nine terms:"});
    canvas.column(kTextMargin_px, 5, lines);
    if (canvas.height_px >= 200) draw_nine_terms(u, v, dots, canvas);
    const Vec3<Counted<double>> some{0, 0, 0};
    const std::array dots_of_some{std::array{some.x, some.y, some.z}, std::array{some.x, some.y, some.z},
                                  std::array{some.x, some.y, some.z}};
    return {{"of the seven hold", input.values[0] == 90 ? 7 : 6, holding},
            {"nine terms; by lengths of u, v, u - v", defined, product(u, v), 1e-4},
            {"the three terms alone miss by", 3 * std::cos(angle), product(u, v) - dot(u, v), 1e-4},
            {"three terms cost", operations_of([&] { dot_by_components(some, some); }).text()},
            {"nine terms cost", operations_of([&] { dot_by_nine_terms(some, some, dots_of_some); }).text()}};
}

}  // namespace

std::vector<Row> aspect_rows() {
    return {{"pixel-aspect", draw_pixel_aspect, {choice_of("mode", kModes)}},
            {"field-of-view",
             draw_field_of_view,
             {choice_of("field of view", kViews, 1), {"pixels divided by", 1, 8, 1, 1}}},
            {"two-multipliers", draw_two_multipliers, {{"pixels are", {"as on the display", "taken for square"}}}},
            {"dot-product-steps", draw_seven_steps, {{"degrees from i to j", 60, 120, 10, 90}}}};
}

}  // namespace oblong
