#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

void add_crystal_on_stem(Draft& draft, const Point& middle, double radius, double height, double turn_degrees,
                         const char* texture) {
    draft.add_detail(make_crystal(middle, radius, height, turn_degrees, texture));
    draft.add_detail_prism({2, circle(8, middle.x, middle.y, 20, 22.5)}, 0, middle.z - height + 10, "marble_green");
}

/// Walls that lean in and out, and a folded ceiling.
void add_tilted_walls(Draft& draft) {
    draft.add(extrude({1, {{1760, 0}, {1760, 256}, {1632, 256}}}, 656, 1072, "brick"));
    draft.add(extrude({0, {{1072, 0}, {1072, 256}, {960, 0}}}, 1344, 1760, "stone_wall"));
    draft.add(extrude({0, {{656, 256}, {1072, 256}, {896, 176}}}, 1344, 1640, "wood_planks"));
    draft.add(extrude({2, {{1760, 656}, {1760, 800}, {1640, 656}}}, 0, 256, "plaster_night"));
}

}  // namespace

void build_plane_room(Draft& draft) {
    const Opening south{Side::South, 1440, 1536, 0, 112};
    const Opening arcade{Side::West, 696, 784, 0, 112}, lift{Side::West, 840, 936, 0, 112};
    build_room(draft, {{{1344, 656, 0}, {1760, 1072, 256}},
                       "diamond",
                       "wood_planks",
                       {{32, "wood_panel"}, {256, "sand_wall"}},
                       {south, arcade, lift}});
    add_tilted_walls(draft);
    add_crystal_on_stem(draft, {1600, 856, 96}, 40, 64, 20, "cube_blue");
    add_crystal_on_stem(draft, {1480, 900, 72}, 26, 44, 50, "cube_gold");
    for (const Opening& door : {arcade, lift}) add_door_frame(draft, Side::East, door, 1344);
    add_sign(draft, {Side::East, {1344, 888, 140}, 1.125, "sign_fov", 176, 32});
    draft.add_light({1560, 760, 150}, 510);
    add_lens(draft, {1548, 932, 0}, "ANY PLANE");
    add_caption(draft, {{1440, 664, 0}, {1536, 696, 72}}, "ANY PLANE - walls and crystals along no axis.",
                "{wireframe} shows the edges of all that is drawn.");
    add_caption(draft, {{1352, 840, 0}, {1376, 936, 72}}, "The lift: stand on it, and it goes up.");
    draft.add_light({1420, 820, 120}, 330);
    add_wall_lamp(draft, {1352, 980, 120}, Side::East, 330);
    draft.add_light({1690, 900, 60}, 310);
}

}  // namespace oblong::map_source
