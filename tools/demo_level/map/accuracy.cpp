#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

constexpr double kWest = -848, kEast = -96, kSouth = 2144, kNorth = 2496, kBottom = -32, kFloor = 48;
constexpr double kPitWest = -720, kPitEast = -224;
constexpr int kFlicker = 6;  // light style: uneven, as of a fire

/// Steps out of a pit, at both of its ends, from the bottom up to the floor.
void add_ledges(Draft& draft, double y_low, double y_high) {
    constexpr double kRise = 16, kRun = 24;
    for (int step = 1; kFloor - kRise * step > kBottom; ++step) {
        const double out = kRun * step, top = kFloor - kRise * step;
        draft.add_box({{kPitWest, y_low, kBottom}, {kPitWest + out, y_high, top}}, "brick");
        draft.add_box({{kPitEast - out, y_low, kBottom}, {kPitEast, y_high, top}}, "brick");
    }
}

void add_floors_and_lava(Draft& draft) {
    const auto add_block = [&](double x_low, double y_low, double x_high, double y_high, const char* top) {
        draft.add_box({{x_low, y_low, kBottom}, {x_high, y_high, kFloor}}, {"brick", "brick", top, "brick"});
    };
    add_block(kWest - kWall, kSouth - kWall, kPitWest, kNorth + kWall, "stone_floor");
    add_block(kPitEast, kSouth - kWall, kEast + kWall, kNorth + kWall, "stone_floor");
    add_block(kPitWest, 2272, kPitEast, 2368, "ruler");
    for (const auto& [y_low, y_high] : {std::pair{kSouth, 2272.0}, {2368.0, kNorth}}) {
        draft.add_box({{kPitWest, y_low, kBottom}, {kPitEast, y_high, 8}}, "*lava");
        add_ledges(draft, y_low, y_high);
    }
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
    add_sign(draft, {Side::South, {-750, kNorth, 240}, 1.75, "sign_accuracy", 112, 32});
    add_sign(draft, {Side::West, {kEast, 2320, 216}, 2.25, "sign_distance", 112, 32});
    draft.add_light({-784, 2440, 200}, 200);
    for (const double x : {-784.0, -160.0}) add_hanging_lamp(draft, {x, 2320, 200}, 272, 370);
    add_lens(draft, {-472, 2320, kFloor}, "ACCURACY");
    add_caption(draft, {{-840, 2150, kFloor}, {-744, 2190, kFloor + 72}},
                "ACCURACY - {accuracy}: in 1991 these stripes bend.", "The lava does no harm; steps lead out.");
}

}  // namespace oblong::map_source
