#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

/// One hue for each axis, as in a draughtsman's drawing.
void add_cube(Draft& draft, const Point& low, double size) {
    const Box box{low, {low.x + size, low.y + size, low.z + size}};
    Brush brush = make_box(box, {"cube_red", "cube_blue", "cube_gold", "cube_gold"});
    fit_textures(brush, box, size / 64);
    draft.add(std::move(brush));
}

/// Cubes piled into the corner: one, two, three storeys, as the cubes of an isometric picture lie.
void add_corner_pile(Draft& draft) {
    constexpr double kSize = 48, kCornerX = 1760, kCornerY = 624;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row + column < 4; ++row) {
            for (int storey = 0; storey + row + column < 4; ++storey) {
                add_cube(draft, {kCornerX - kSize * (column + 1), kCornerY - kSize * (row + 1), kSize * storey}, kSize);
            }
        }
    }
}

/// A cube's frame of twelve beams, drawn in space.
void add_wire_cube(Draft& draft, const Point& low, double size, double beam) {
    const std::array<double, 2> ends{0, size - beam};
    for (const double a : ends) {
        for (const double b : ends) {
            const Point x{low.x, low.y + a, low.z + b}, y{low.x + a, low.y + beam, low.z + b};
            const Point z{low.x + a, low.y + b, low.z + beam};
            draft.add_detail_box({x, {x.x + size, x.y + beam, x.z + beam}}, "brass_panel");
            draft.add_detail_box({y, {y.x + beam, y.y + size - 2 * beam, y.z + beam}}, "brass_panel");
            draft.add_detail_box({z, {z.x + beam, z.y + beam, z.z + size - 2 * beam}}, "brass_panel");
        }
    }
}

}  // namespace

void build_axonometry_room(Draft& draft) {
    const Opening west{Side::West, 368, 464, 0, 112}, north{Side::North, 1440, 1536, 0, 112};
    build_room(draft, {{{1344, 208, 0}, {1760, 624, 224}},
                       "grid_paper",
                       "wood_planks",
                       {{192, "grid_paper"}, {224, "sand_frieze"}},
                       {west, north}});
    add_corner_pile(draft);
    draft.add_detail_prism({2, circle(8, 1468, 284, 44, 22.5)}, 0, 40, "marble_green");
    add_wire_cube(draft, {1436, 252, 56}, 64, 6);
    add_cube(draft, {1452, 268, 72}, 32);
    draft.add_box({{1464, 280, 40}, {1472, 288, 72}}, "brass_trim");
    add_door_frame(draft, Side::South, north, 624);
    add_sign(draft, {Side::South, {1488, 624, 144}, 1, "sign_planes", 128, 32});
    add_panel(draft, {Side::North, {{1600, 208, 56}, {1696, 212, 152}}, "picture_cubes"});
    draft.add_light({1400, 250, 150}, 300);
    add_lens(draft, {1552, 416, 0}, "AXONOMETRY");
    add_caption(draft, {{1352, 368, 0}, {1384, 464, 72}}, "AXONOMETRY - from the lens, the pile is flat.",
                "{isometric} shows the level from outside, like this.");
    draft.add_light({1500, 360, 190}, 660);
    add_wall_lamp(draft, {1752, 288, 136}, Side::West, 290);
    add_wall_lamp(draft, {1352, 560, 136}, Side::East, 290);
}

}  // namespace oblong::map_source
