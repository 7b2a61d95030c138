#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {

/// The shaft goes 24 units below the floor, where the platform (16 thick) waits: level with the rooms below, it lifts
/// 160 units to the balcony.
void build_lift(Draft& draft) {
    const Opening below{Side::East, 840, 936, 0, 112}, above{Side::West, 840, 936, 160, 272};
    build_room(draft, {{{1184, 824, -24}, {1312, 952, 304}},
                       "iron_grate",
                       "iron_grate",
                       {{0, "stone_wall"}, {160, "brass_panel"}, {304, "stone_wall"}},
                       {below, above}});
    const Box platform{{1186, 826, 144}, {1310, 950, 160}};
    draft.add_entity({{{"classname", "func_plat"}, {"height", "160"}, {"speed", "100"}, {"sounds", "1"}},
                      {make_box(platform, {"brass_trim", "brass_trim", "iron_grate", "iron_grate"})}});
    // Lamps let into the wall, so that the platform passes them.
    for (const double z : {56.0, 216.0}) {
        add_panel(draft, {Side::South, {{1232, 950, z}, {1264, 952, z + 32}}, "lamp", 32, 32});
        draft.add_light({1248, 930, z + 16}, 330);
    }
}

}  // namespace oblong::map_source
