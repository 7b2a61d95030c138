// Seed 1 (Muratori): the shape of pixels, and the projection that knows it.

#include "engine/geometry/projection.h"
#include "tools/common/drawing.h"
#include "tools/gallery/rows.h"

namespace oblong {

namespace {

struct NamedMode {
    const char* name;
    ScreenMode mode;
    double multiplier_y;  ///< at 90 degrees across, from the seed
};
constexpr std::array<NamedMode, 3> kModes{{{"320x200 on 4:3", {320, 200, {4, 3}}, 133.333333333},
                                           {"640x480 on 4:3", {640, 480, {4, 3}}, 320},
                                           {"640x480 on 1.85", {640, 480, {37, 20}}, 444}}};

RowPage draw_multipliers(const RowInput& input, Framebuffer canvas) {
    fill_area(canvas, {0, 0, canvas.width_px, canvas.height_px}, input.assets.colour(24, 28, 40));
    const NamedMode& named = kModes[static_cast<std::size_t>(input.values[0])];
    const Projection projection = make_projection(named.mode, Degrees::from_int(90), true);
    RowPage page;
    page.figures.push_back(number_figure("multiplier of y, pixels", named.multiplier_y,
                                         static_cast<double>(projection.y.multiplier.raw) / 65536 / 65536, 1e-8));
    return page;
}

}  // namespace

std::vector<Row> aspect_rows() {
    return {{"multipliers",
             "The two multipliers",
             "1 Muratori: projection",
             "engine/geometry/projection.h",
             "tests/seeds/muratori_test.cpp",
             {choice_parameter("mode", {kModes[0].name, kModes[1].name, kModes[2].name})},
             draw_multipliers}};
}

}  // namespace oblong
