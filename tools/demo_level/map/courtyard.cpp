#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"
#include "tools/demo_level/map/room.h"

namespace oblong::map_source {
namespace {

constexpr double kGround = -112;

/// The ground is thick enough for the canal's banks: their sides are tiled.
void add_ground(Draft& draft, double x_low, double y_low, double x_high, double y_high, const char* top) {
    draft.add_box({{x_low, y_low, kGround}, {x_high, y_high, 0}}, {"basin_tiles", "basin_tiles", top, "stone_wall"});
}

/// Lawns left and right of a path, a paved strip under the colonnade and one under the balcony.
void add_bank(Draft& draft, double y_low, double y_high) {
    add_ground(draft, -272, y_low, -112, y_high, "stone_floor");
    add_ground(draft, -112, y_low, 432, y_high, "earth");
    add_ground(draft, 432, y_low, 592, y_high, "stone_floor");
    add_ground(draft, 592, y_low, 1008, y_high, "earth");
    add_ground(draft, 1008, y_low, 1168, y_high, "stone_floor");
}

/// A cypress in a tub of stone.
void add_tree(Draft& draft, double x, double y) {
    draft.add_detail_prism({2, circle(6, x, y, 22, 30)}, 0, 20, "marble_ivory");
    draft.add_detail(make_cone({x, y, 20}, 28, 170, "hedge"));
}

/// Lamps, trees and hedges along the walls and in the corners.
void add_plants(Draft& draft) {
    for (const Point& lamp : {Point{1090, 610, 0},
                              {930, 620, 0},
                              {1090, 1900, 0},
                              {820, 1900, 0},
                              {240, 1900, 0},
                              {-40, 1900, 0},
                              {60, 620, 0},
                              {1090, 1440, 0},
                              {-40, 1120, 0},
                              {280, 1720, 0},
                              {790, 1700, 0},
                              {-40, 1420, 0}})
        add_lamp_post(draft, lamp, 290);
    for (const Point& tree : {Point{980, 590, 0},
                              {1110, 670, 0},
                              {1110, 1830, 0},
                              {1000, 1930, 0},
                              {740, 1930, 0},
                              {320, 1930, 0},
                              {140, 1930, 0},
                              {-60, 1780, 0},
                              {-60, 980, 0},
                              {-60, 700, 0}})
        add_tree(draft, tree.x, tree.y);
    for (const double x : {-96.0, 608.0}) {
        for (const double y : {1180.0, 1340.0})
            draft.add_detail_box({{x, y - 8, 0}, {x < 0 ? 256.0 : 990.0, y + 8, 28}}, "hedge");
    }
}

void add_moonlight(Draft& draft) {
    for (const double y : {690.0, 1080.0, 1480.0, 1880.0}) {
        for (const double x : {-40.0, 450.0, 940.0}) draft.add_light({x, y, 480}, 745);
    }
}

}  // namespace

void build_courtyard(Draft& draft) {
    build_walls(draft, {{{-256, 544, 0}, {1152, 1984, 704}},
                        "",
                        "",
                        {{32, "stone_dark"}, {256, "stone_wall"}, {288, "sand_frieze"}, {704, "sky_night"}},
                        {{Side::South, 24, 200, 56, 232},
                         {Side::South, 688, 784, 0, 112},
                         {Side::East, 696, 784, 0, 112},
                         {Side::East, 840, 936, 160, 272},
                         {Side::East, 1568, 1664, 0, 112},
                         {Side::West, 1536, 1632, 0, 112},
                         {Side::North, 448, 576, 32, 176}}});
    draft.add_box({{-272, 528, 704}, {1168, 2000, 720}}, "sky_night");
    add_ground(draft, -272, 528, 1168, 704, "stone_floor");
    add_bank(draft, 704, 1200);
    add_bank(draft, 1328, 2000);
    add_ground(draft, 1008, 1200, 1168, 1328, "stone_floor");
    for (const double x : {400.0, 624.0}) {
        draft.add_detail_prism({2, circle(8, x, 1080, 22, 22.5)}, 0, 22, "marble_green");
        draft.add_detail(make_sphere({x, 1080, 50}, 0.5, "marble_ivory", "marble_ivory", 2));
    }
    for (const double y : {736.0, 960.0, 1440.0}) {
        for (const double x : {416.0, 608.0}) add_lamp_post(draft, {x, y, 0}, 290);
    }
    add_way_board(draft, {Side::South, {340, 1440, 78}, 1, "sign_forced", 160, 48});
    add_sign(draft, {Side::West, {1152, 1616, 158}, 2.25, "sign_rain", 64, 32});
    for (const double y : {1540.0, 1692.0}) add_wall_lamp(draft, {1144, y, 96}, Side::West, 360);
    for (const double x : {300.0, 424.0, 600.0}) add_wall_lamp(draft, {x, 552, 112}, Side::North, 400);
    add_plants(draft);
    add_moonlight(draft);
    add_caption(draft, {{688, 560, 0}, {784, 600, 72}}, "THE COURTYARD - twelve lenses open the tower.",
                "Tab shows a map.");
}

void build_canal(Draft& draft) {
    draft.add_box({{-272, 1200, kGround}, {1008, 1328, -96}}, "basin_tiles");
    draft.add_box({{-272, 1200, kGround}, {-256, 1328, 0}}, "basin_tiles");
    draft.add_box({{-256, 1200, -96}, {1008, 1328, -24}}, "*water");
    for (int step = 1; step < 6; ++step) {
        draft.add_box({{1008.0 - 24 * step, 1200, -96}, {1032.0 - 24 * step, 1328, -16.0 * step}}, "basin_tiles");
    }
    for (double x = -160; x < 900; x += 192) draft.add_light({x, 1264, -56}, 290);
    // The bridge: a step, an abutment, the deck, and the same again.
    draft.add_detail_box({{432, 1152, 0}, {592, 1176, 16}}, "stone_floor");
    draft.add_detail_box({{432, 1352, 0}, {592, 1376, 16}}, "stone_floor");
    for (const double y : {1176.0, 1328.0}) draft.add_detail_box({{432, y, 0}, {592, y + 24, 16}}, "stone_wall");
    draft.add_detail_box({{432, 1176, 16}, {592, 1352, 32}}, {"sand_frieze", "stone_floor"});
    for (const double x : {434.0, 590.0}) {
        add_balustrade(draft, {x, 1178, 32}, {x, 1350, 32}, "marble_ivory");
        for (const double y : {1164.0, 1364.0}) add_lamp_post(draft, {x, y, 16}, 290);
    }
}

void build_balcony(Draft& draft) {
    draft.add_detail_box({{1008, 760, 144}, {1152, 1040, 160}}, {"sand_frieze", "stone_floor"});
    for (const double y : {776.0, 900.0, 1024.0}) add_column(draft, {1024, y, 0}, 144, 12, "marble_ivory");
    add_stairs(draft, {1072, 1152, 1280, 0, 24, 10, false}, {"sand_wall", "stone_floor"});
    add_balustrade(draft, {1012, 764, 160}, {1012, 1036, 160}, "marble_ivory");
    add_balustrade(draft, {1012, 764, 160}, {1150, 764, 160}, "marble_ivory");
    add_balustrade(draft, {1012, 1036, 160}, {1060, 1036, 160}, "marble_ivory");
    add_wall_lamp(draft, {1144, 800, 232}, Side::West, 290);
    add_wall_lamp(draft, {1144, 980, 232}, Side::West, 290);
    add_lamp_post(draft, {1032, 1180, 0}, 290);
    add_wall_lamp(draft, {1144, 828, 72}, Side::West, 330);
    add_lens(draft, {1046, 940, 160}, "FIELD OF VIEW");
    add_caption(draft, {{1112, 840, 160}, {1148, 936, 232}}, "FIELD OF VIEW - [ and ] make it wide or narrow;",
                "what is in the middle keeps its size.");
    build_room(draft, {{{1184, 688, 0}, {1312, 792, 128}},
                       "stone_floor",
                       "wood_planks",
                       {{32, "wood_panel"}, {128, "sand_wall"}},
                       {{Side::East, 696, 784, 0, 112}, {Side::West, 696, 784, 0, 112}}});
    add_hanging_lamp(draft, {1248, 740, 100}, 128, 330);
}

void build_colonnade(Draft& draft) {
    for (double y = 600; y < 1960; y += 104) add_column(draft, {-132, y, 0}, 160, 14, "marble_ivory");
    draft.add_detail_box({{-256, 544, 160}, {-112, 1984, 176}},
                         {"sand_frieze", "sand_frieze", "copper_roof", "wood_planks"});
    draft.add_box({{-256, 1200, -16}, {-112, 1328, 0}}, {"sand_frieze", "stone_floor"});
    for (double y = 690; y < 1960; y += 330) add_wall_lamp(draft, {-248, y, 104}, Side::East, 370);
}

}  // namespace oblong::map_source
