#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

constexpr double kNorth = 512, kSouth = 320, kMiddle = 416;

void add_pictures(Draft& draft) {
    const std::array<const char*, 4> pictures{"picture_road", "picture_cubes", "picture_eye", "picture_moon"};
    for (std::size_t i = 0; i < 8; ++i) {
        if (i == 3) continue;  // the ways out to the courtyard and to the light hall
        const double x = 352 + 128 * static_cast<double>(i);
        add_panel(draft, {Side::North, {{x - 32, kSouth, 48}, {x + 32, kSouth + 4, 112}}, pictures[i % 4]});
        add_panel(draft, {Side::South, {{x - 32, kNorth - 4, 48}, {x + 32, kNorth, 112}}, pictures[(i + 2) % 4]});
    }
}

void add_columns_and_lamps(Draft& draft) {
    for (double x = 416; x <= 1184; x += 128) {
        for (const double y : {kSouth + 28, kNorth - 28}) add_column(draft, {x, y, 0}, 176, 12, "marble_ivory");
    }
    for (double x = 352; x <= 1248; x += 256) add_hanging_lamp(draft, {x, kMiddle, 144}, 176, 420);
}

/// Two leaves that slide into the wall.
void add_sliding_door(Draft& draft) {
    for (const double y : {368.0, 416.0}) {
        const Box leaf{{1320, y, 0}, {1336, y + 48, 112}};
        Brush brush = make_box(leaf, "wood_door");
        fit_textures(brush, leaf, 0.875);
        draft.add_entity({{{"classname", "func_door"},
                           {"angle", y < kMiddle ? "270" : "90"},
                           {"lip", "4"},
                           {"speed", "80"},
                           {"wait", "3"}},
                          {brush}});
    }
}

}  // namespace

void build_gallery(Draft& draft) {
    const Opening west{Side::West, 368, 464, 0, 112}, east{Side::East, 368, 464, 0, 112};
    const Opening courtyard{Side::North, 688, 784, 0, 112}, light_hall{Side::South, 688, 784, 0, 112};
    build_room(draft, {{{288, kSouth, 0}, {1312, kNorth, 176}},
                       "checker",
                       "coffer",
                       {{32, "wood_panel"}, {144, "sand_wall"}, {176, "sand_frieze"}},
                       {west, east, courtyard, light_hall}});
    add_arch(draft, 1, {{688, kNorth, 0}, {784, 544, 112}}, "sand_wall");
    add_pictures(draft);
    add_columns_and_lamps(draft);
    add_door_frame(draft, Side::West, east, 1312);
    add_hanging_sign(draft, {Side::West, {512, kMiddle, 149}, 1, "sign_axono", 144, 32}, 176);
    add_sliding_door(draft);
    add_door_frame(draft, Side::North, light_hall, kSouth);
    add_sign(draft, {Side::North, {736, kSouth, 144}, 1, "sign_light", 128, 48});
    add_lens(draft, {1232, kMiddle, 0}, "the VANISHING POINT");
    add_caption(draft, {{300, 368, 0}, {330, 464, 72}}, "VANISHING POINT - all lines meet in one.",
                "{accuracy}: how textures bend; {split} compares.");
}

}  // namespace oblong::map_source
