#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {

namespace {

/// From forced perspective north to accuracy.
void build_west_passage(Draft& draft) {
    const std::vector<WallBand> stone{{80, "wood_panel"}, {176, "sand_wall"}};
    build_room(draft, {{{-848, 1520, 48}, {-736, 2112, 176}},
                       "stone_floor",
                       "wood_planks",
                       stone,
                       {{Side::East, 1536, 1632, 48, 160}, {Side::North, -840, -744, 48, 160}}});
    constexpr int kFlickers = 1;  // light style
    for (const double y : {1700.0, 2020.0}) add_hanging_lamp(draft, {-792, y, 148}, 176, 340);
    add_hanging_lamp(draft, {-792, 1860, 148}, 176, 340, kFlickers);
    draft.add_point("misc_sparks", {-792, 1860, 136},
                    {{"size", "48 48 72"}, {"count", "24"}, {"colour", "231 225"}, {"period", "2"}});
    add_panel(draft, {Side::West, {{-740, 1740, 84}, {-736, 1804, 148}}, "picture_road"});

    // At the end of forced perspective: small, and taken for large.
    add_panel(draft, {Side::East, {{-848, 1566, 92}, {-844, 1602, 128}}, "picture_moon"});
    draft.add_light({-800, 1584, 140}, 260);
}

/// Long and pale, between two rows of columns: distance shows.
void build_pale_corridor(Draft& draft) {
    build_room(draft, {{{-64, 2256, 48}, {592, 2384, 192}},
                       "stone_floor",
                       "plaster_ivory",
                       {{192, "plaster_ivory"}},
                       {{Side::West, 2272, 2368, 48, 160}, {Side::South, 464, 560, 48, 160}}});
    for (double x = 0; x < 448; x += 96) {
        for (const double y : {2268.0, 2372.0}) add_column(draft, {x, y, 48}, 144, 8, "marble_ivory");
    }
    for (const double x : {48.0, 240.0, 432.0}) draft.add_light({x, 2320, 150}, 320);
    add_caption(draft, {{-40, 2272, 48}, {-8, 2368, 120}}, "DISTANCE - far columns are drawn from small",
                "copies of their texture. The tower is ahead.");
}

/// From the corridor over the courtyard's wall into the tower.
void build_tower_bridge(Draft& draft) {
    draft.add_box({{448, 1856, 0}, {576, 1984, 32}}, "stone_dark");
    build_room(draft, {{{464, 1856, 48}, {560, 2224, 160}},
                       "stone_floor",
                       "stone_dark",
                       {{160, "stone_dark"}},
                       {{Side::North, 464, 560, 48, 160}, {Side::South, 472, 552, 48, 160}}});
    add_hanging_sign(draft, {Side::North, {512, 2080, 142}, 0.75, "+0exit", 112, 32}, 160);
    draft.add_light({512, 2180, 130}, 310);
    draft.add_light({512, 1960, 130}, 240);
}

}  // namespace

/// All three lie 48 units above the courtyard.
void build_passages(Draft& draft) {
    build_west_passage(draft);
    build_pale_corridor(draft);
    build_tower_bridge(draft);
}

}  // namespace oblong::map_source
