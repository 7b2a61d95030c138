#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

constexpr double kWest = -848, kEast = -96, kSouth = 2144, kNorth = 2496, kBottom = -32, kFloor = 48;
constexpr int kFlicker = 6;  // light style: uneven, as of a fire

void add_floors_and_lava(Draft& draft) {
    const auto add_block = [&](double x_low, double y_low, double x_high, double y_high, const char* top) {
        draft.add_box({{x_low, y_low, kBottom}, {x_high, y_high, kFloor}}, {"brick", "brick", top, "brick"});
    };
    add_block(kWest - kWall, kSouth - kWall, -720, kNorth + kWall, "stone_floor");
    add_block(-224, kSouth - kWall, kEast + kWall, kNorth + kWall, "stone_floor");
    add_block(-720, 2272, -224, 2368, "ruler");
    draft.add_box({{-720, kSouth, kBottom}, {-224, 2272, 8}}, "*lava");
    draft.add_box({{-720, 2368, kBottom}, {-224, kNorth, 8}}, "*lava");
    for (double x = -672; x < -224; x += 100) {
        draft.add_light({x, 2208, 32}, 290, kFlicker);
        draft.add_light({x, 2432, 32}, 290, kFlicker);
    }
}

}  // namespace

/// Thin stripes seen along the floor, along the walls and on a leaning board: where a texture is not divided by
/// depth, they bend.
void build_accuracy_room(Draft& draft) {
    build_room(draft,
               {{{kWest, kSouth, kBottom}, {kEast, kNorth, 272}},
                "brick",
                "wood_planks",
                {{kFloor, "brick"}, {112, "stone_dark"}, {176, "ruler"}, {240, "stone_dark"}, {272, "sand_frieze"}},
                {{Side::South, -840, -744, 48, 160}, {Side::East, 2272, 2368, 48, 160}}});
    add_floors_and_lava(draft);
    draft.add(extrude({0, {{kSouth, kFloor}, {kSouth, 240}, {kSouth + 56, kFloor}}}, -680, -264, "ruler"));
    add_panel(draft, {Side::South, {{-848, kNorth - 4, 180}, {-720, kNorth, 212}}, "sign_accuracy", 128, 32});
    add_panel(draft, {Side::West, {{kEast - 4, 2256, 176}, {kEast, 2384, 208}}, "sign_distance", 128, 32});
    draft.add_light({-784, 2440, 200}, 200);
    for (const double x : {-784.0, -160.0}) add_hanging_lamp(draft, {x, 2320, 200}, 272, 370);
}

}  // namespace oblong::map_source
