// Seed 1 (Muratori): the shape of pixels, the field of view, and the projection that knows both.

#include <array>
#include <cmath>
#include <numbers>

#include "engine/geometry/project.h"
#include "tools/common/drawing.h"
#include "tools/gallery/diagram.h"
#include "tools/gallery/level_scene.h"
#include "tools/gallery/numbers.h"
#include "tools/gallery/rows.h"

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

Parameter mode_parameter() {
    std::vector<std::string> names;
    for (const NamedMode& named : kModes) names.push_back(named.name);
    return choice_parameter("mode", names);
}

const NamedMode& mode_of(const RowInput& input, std::size_t parameter) {
    return at(kModes, input.values[parameter]);
}

/// The display's outline, and in it a disc of so few pixels that their shape is seen.
RowPage draw_pixel_aspect(const RowInput& input, Framebuffer canvas) {
    const NamedMode& named = mode_of(input, 0);
    const GalleryAssets& assets = input.assets;
    const Ratio display = named.mode.display, pixel = named.mode.pixel();
    const double wide = static_cast<double>(display.numerator) / static_cast<double>(display.denominator);
    const double shape = static_cast<double>(pixel.numerator) / static_cast<double>(pixel.denominator);
    Diagram diagram(input, canvas, {0, 0}, 1.12);
    diagram.fill(assets.colour(20, 24, 36));
    constexpr int kRows = 15;
    const double high = 1.0 / kRows, across = high * shape;
    const int columns = static_cast<int>(wide / across / 2) + 1;
    for (int row = -kRows / 2; row <= kRows / 2; ++row)
        for (int column = -columns; column <= columns; ++column) {
            const PlanePoint middle{column * across, row * high};
            if (std::abs(middle.x) + across / 2 > wide / 2 + 1e-9) continue;
            const bool is_in_disc = std::hypot(middle.x, middle.y) < 0.4;
            const std::uint8_t colour = is_in_disc ? assets.colour(220, 150, 60) : assets.colour(44, 54, 76);
            diagram.rectangle({middle.x - across * 0.44, middle.y - high * 0.44},
                              {middle.x + across * 0.44, middle.y + high * 0.44}, colour);
        }
    diagram.circle({0, 0}, 0.4, assets.colour(240, 230, 200));
    diagram.outline({-wide / 2, -0.5}, {wide / 2, 0.5}, assets.colour(150, 160, 180));
    const double a = static_cast<double>(named.a.numerator) / static_cast<double>(named.a.denominator);
    const Projection projection = make_projection(named.mode, Degrees::from_int(90));
    return {
        {number_figure("a = w / (r h): pixel's height to width", a, 1 / shape, 1e-12, 6),
         number_figure("multiplier of y / multiplier of x = 1 / a", 1 / a,
                       number_of(projection.y.multiplier) / number_of(projection.x.multiplier), 1e-8, 6)},
        {"One in " + std::to_string(named.mode.height_px / kRows) +
             " rows of pixels is drawn, in the shape that the display gives them. The circle is round; so is a disc "
             "of these pixels whose rows were counted with a.",
         "The seed's prose has it the other way round: a pixel is a times as high as it is wide."}};
}

constexpr std::array<int, 3> kFieldsOfView{60, 90, 120};
/// The distance of the viewplane for 320 columns, and the field of view from top to bottom on 4:3: the seed's,
/// recomputed.
struct ExpectedView {
    double distance_px, vertical_degrees;
};
constexpr std::array<ExpectedView, 3> kExpectedViews{
    {{277.128129211, 46.826449}, {160, 73.739795}, {92.376043070, 104.821821}}};

/// Draws a picture of another mode over the whole canvas, its pixels enlarged.
void enlarge(std::span<const std::uint8_t> pixels, const ScreenMode& mode, Framebuffer canvas) {
    for (std::int32_t y = 0; y < canvas.height_px; ++y)
        for (std::int32_t x = 0; x < canvas.width_px; ++x) {
            const std::int64_t column = std::int64_t{x} * mode.width_px / canvas.width_px;
            const std::int64_t row = std::int64_t{y} * mode.height_px / canvas.height_px;
            canvas.row(y)[x] = pixels[static_cast<std::size_t>(row * mode.width_px + column)];
        }
}

RowPage draw_field_of_view(const RowInput& input, Framebuffer canvas) {
    const auto choice = static_cast<std::size_t>(input.values[0]);
    const auto divisor = static_cast<std::int32_t>(input.values[1]);
    const ScreenMode mode{std::max(input.mode.width_px / divisor, 40), std::max(input.mode.height_px / divisor, 25),
                          input.mode.display};
    const int degrees = kFieldsOfView[choice];
    std::vector<std::uint8_t> pixels(pixel_count(mode.width_px, mode.height_px));
    draw_demo_level(input, camera_at(0, -368, 70, 90, -4, degrees), mode,
                    {pixels.data(), mode.width_px, mode.height_px, mode.width_px});
    enlarge(pixels, mode, canvas);
    const Projection at_320 = make_projection({320, 200, {4, 3}}, Degrees::from_int(degrees));
    const Projection here = make_projection(mode, Degrees::from_int(degrees));
    const double vertical = 2 * std::atan(100 / number_of(at_320.y.multiplier)) * 180 / std::numbers::pi;
    return {{number_figure("distance of the viewplane for 320 columns, pixels", kExpectedViews[choice].distance_px,
                           number_of(at_320.x.multiplier), 1e-6),
             number_figure("field of view from top to bottom, degrees", kExpectedViews[choice].vertical_degrees,
                           vertical, 1e-6),
             number_figure("distance / columns, the same in every mode", kExpectedViews[choice].distance_px / 320,
                           number_of(here.x.multiplier) / mode.width_px, 1e-8, 6)},
            {"d = (w / 2) / tan(angle / 2): with fewer columns d shrinks as they do, and the view stays the same."}};
}

/// The demo level's sphere, from far enough that perspective does not stretch it by a hundredth.
Camera camera_before_sphere() {
    return camera_at(-112, 352 - 300, 128, 90, 0, 40);
}

RowPage draw_two_multipliers(const RowInput& input, Framebuffer canvas) {
    RowInput square = input;
    square.settings.correct_aspect = input.values[0] == 0;
    draw_demo_level(square, camera_before_sphere(), input.mode, canvas);
    const Projection projection = make_projection(input.mode, Degrees::from_int(40), square.settings.correct_aspect);
    // A square of 1 x 1 unit, 4 units away.
    const auto corner = [&](std::int64_t x, std::int64_t y) {
        return project({View::from_int(x), View::from_int(y), View::from_int(4)}, projection);
    };
    const double columns = number_of(corner(1, 0).x - corner(0, 0).x),
                 rows = number_of(corner(0, 0).y - corner(0, 1).y);
    const Ratio pixel = input.mode.pixel();
    const double shape = static_cast<double>(pixel.numerator) / static_cast<double>(pixel.denominator);
    const double right_shape = square.settings.correct_aspect ? 1 : shape;
    return {{number_figure("width to height of a square as shown", right_shape, columns / rows * shape, 0.005),
             measured("multiplier of x, pixels", decimal_text(number_of(projection.x.multiplier))),
             measured("multiplier of y, pixels", decimal_text(number_of(projection.y.multiplier)))},
            {"Aspect and field of view are in the two multipliers, computed once for a mode. A point costs a "
             "multiplication and a "
             "division for each axis, in both pictures: they are drawn by the same code with other numbers."}};
}

}  // namespace

std::vector<Row> aspect_rows() {
    return {{"pixel-aspect",
             "Aspect of pixels",
             "1 Muratori: Dealing with Aspect Ratios",
             "engine/screen/screen.h",
             "tests/seeds/muratori_test.cpp",
             {mode_parameter()},
             draw_pixel_aspect},
            {"field-of-view",
             "Field of view and viewplane",
             "1 Muratori: Using Field of View",
             "engine/geometry/projection.cpp",
             "tests/seeds/muratori_test.cpp",
             {choice_parameter("field of view", {"60 degrees", "90 degrees", "120 degrees"}, 1),
              {"pixels divided by", 1, 8, 1, 1}},
             draw_field_of_view},
            {"two-multipliers",
             "The two multipliers",
             "1 Muratori: Using Field of View",
             "engine/geometry/project.h",
             "tests/seeds/muratori_test.cpp",
             {choice_parameter("pixels are", {"as on the display", "taken for square"})},
             draw_two_multipliers}};
}

}  // namespace oblong
