#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

constexpr Box kGarden{{1184, 1856, -208}, {1600, 2528, 320}};
constexpr double kPathX = 1392, kLawn = kGarden.low.z;

/// From the door in the south, at the height of the other rooms, down to the lawn.
void add_way_down(Draft& draft) {
    constexpr double kHalf = 64, kLanding = 1888, kRun = 24;
    constexpr int kSteps = 12;
    const Skin stone{"sand_wall", "sand_frieze", "stone_floor", "stone_floor"};
    draft.add_box({{kPathX - kHalf, kGarden.low.y, kLawn}, {kPathX + kHalf, kLanding, 0}}, stone);
    add_stairs(draft, {kPathX - kHalf, kPathX + kHalf, kLanding + kSteps * kRun, kLawn, kRun, kSteps, false}, stone);
    for (const double x : {kPathX - kHalf + 4, kPathX + kHalf - 4}) {
        add_balustrade(draft, {x, kGarden.low.y + 4, 0}, {x, kLanding - 4, 0}, "marble_ivory");
        draft.add_detail_box({{x - 6, kLanding - 12, 0}, {x + 6, kLanding, 40}}, "marble_ivory");
    }
}

void add_garden_tree(Draft& draft, double x, double y) {
    draft.add_detail_box({{x - 8, y - 8, kLawn}, {x + 8, y + 8, kLawn + 24}}, "wood_panel");
    draft.add_detail(make_cone({x, y, kLawn + 24}, 34, 186, "hedge"));
}

void add_lawns(Draft& draft) {
    draft.add_detail_box({{kPathX - 40, 2176, kLawn}, {kPathX + 40, 2500, kLawn + 1}}, "stone_floor");
    for (const double y : {1930.0, 2050.0, 2190.0, 2340.0}) {
        for (const double x : {kPathX - 140, kPathX + 140})
            add_garden_tree(draft, x + (y < 2000 || y > 2200 ? 0 : x < kPathX ? -20 : 20), y);
    }
    for (const double x : {kGarden.low.x, kGarden.high.x - 24})
        draft.add_detail_box({{x, kGarden.low.y, kLawn}, {x + 24, kGarden.high.y, kLawn + 40}}, "hedge");
    // Far enough from the trees that nobody is caught between them.
    for (const double x : {kPathX - 88, kPathX + 88}) add_lamp_post(draft, {x, 2112, kLawn}, 280);
    for (const double y : {2210.0, 2400.0}) {
        for (const double x : {kPathX - 60, kPathX + 60}) add_lamp_post(draft, {x, y, kLawn}, 280);
    }
}

/// Between two pillars at the end of the path: out to the courtyard, before the next room.
void add_teleporter(Draft& draft) {
    constexpr double kHalf = 40, kHigh = 112, y = 2496;
    const Box field{{kPathX - kHalf, y, kLawn}, {kPathX + kHalf, y + 8, kLawn + kHigh}};
    draft.add_box(field, "*teleport");
    for (const double x : {field.low.x - 24, field.high.x})
        draft.add_box({{x, y - 8, kLawn}, {x + 24, y + 32, kLawn + kHigh}}, "marble_green");
    draft.add_box({{field.low.x, y + 8, kLawn}, {field.high.x, y + 32, kLawn + kHigh}}, "marble_green");
    draft.add_box({{field.low.x - 28, y - 12, kLawn + kHigh}, {field.high.x + 28, y + 32, kLawn + kHigh + 20}},
                  "sand_frieze");
    draft.add_light({kPathX, y - 48, kLawn + 70}, 300, 2);
    draft.add_entity({{{"classname", "trigger_teleport"}, {"target", "from_the_garden"}},
                      {make_box({{field.low.x, y - 8, kLawn}, {field.high.x, y, kLawn + kHigh}}, "brass_trim")}});
    draft.add_point("info_teleport_destination", {40, 1600, 0}, {{"targetname", "from_the_garden"}, {"angle", "180"}});
}

void add_light_of_sky(Draft& draft) {
    for (const double y : {1960.0, 2190.0, 2420.0}) {
        for (const double x : {1290.0, 1494.0}) draft.add_light({x, y, 150}, 420);
    }
}

}  // namespace

std::string fog_of_garden() {
    return "0.45 0.36 0.42 0.55 1 0 16384 -112 56";
}

/// Sunken below all other rooms: the fog lies in it.
void build_fog_garden(Draft& draft) {
    build_room(draft, {kGarden,
                       "earth",
                       "sky_night",
                       {{-144, "stone_dark"}, {128, "stone_wall"}, {160, "sand_frieze"}, {320, "sky_night"}},
                       {{Side::South, 1344, 1440, 0, 112}}});
    add_way_down(draft);
    add_lawns(draft);
    add_teleporter(draft);
    add_light_of_sky(draft);
    add_lens(draft, {kPathX + 66, 2310, kLawn}, "FOG");
    add_caption(draft, {{1344, 1864, 0}, {1440, 1884, 72}}, "FOG - it lies where the ground is low.",
                "The arch at the end leads back.");
    for (const double x : {1320.0, 1464.0}) add_wall_lamp(draft, {x, kGarden.low.y + 8, 80}, Side::North, 320);
}

}  // namespace oblong::map_source
