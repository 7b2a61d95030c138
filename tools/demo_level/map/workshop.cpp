#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

constexpr int kStrobe = 4, kFluorescent = 10, kOwnStyle = 32;  // light styles; from 32 on a light may say its own

/// Behind bars, from wall to wall: a dynamo with its dial, and a sign that tells of the current.
void add_dynamo(Draft& draft) {
    const Box cage{{1220, 0, 0}, {1224, 288, 176}};
    Brush bars = make_box(cage, "{grate");
    fit_textures(bars, cage, 1);
    draft.add(bars);
    draft.add_detail_box({{1252, 40, 0}, {1312, 120, 64}}, "brass_panel");
    draft.add_detail_box({{1264, 56, 64}, {1312, 104, 96}}, "copper_roof");
    draft.add_detail_prism({0, circle(12, 208, 56, 40, 15)}, 1264, 1296, "brass_panel");
    draft.add_detail_box({{1248, 200, 48}, {1312, 216, 64}}, "brass_trim");
    add_panel(draft, {Side::West, {{1248, 56, 8}, {1252, 104, 56}}, "brass_dial"});
    add_sign(draft, {Side::West, {1312, 144, 120}, 0.75, "+0volt", 64, 64});
    draft.add_point("light", {1280, 144, 104},
                    {{"light", "260"},
                     {"wait", "1.5"},
                     {"style", std::to_string(kOwnStyle)},
                     {"pattern", "mmnmmommommnonmmonqnmmo"}});
    draft.add_light({1240, 40, 140}, 200, kStrobe);
}

/// A lamp that hangs by one of its wires: it sparks.
void add_broken_lamp(Draft& draft, const Point& centre, double ceiling) {
    const Box body = within({{centre.x - 8, centre.y - 8, centre.z - 8}, {centre.x + 8, centre.y + 8, centre.z + 8}});
    Brush glass = make_box(body, "lamp_dead");
    fit_textures(glass, body, 0.5);
    draft.add_detail(std::move(glass));
    draft.add_detail_box({{centre.x + 5, centre.y - 1, centre.z + 8}, {centre.x + 7, centre.y + 1, ceiling}},
                         "brass_trim");
    draft.add_point("misc_sparks", {centre.x, centre.y, centre.z - 12},
                    {{"size", "64 64 72"}, {"count", "48"}, {"colour", "231 225"}, {"period", "1.5"}});
    draft.add_light({centre.x, centre.y, centre.z - 24}, 330, kFluorescent);
}

void add_benches(Draft& draft) {
    for (const double y : {0.0, 248.0}) {
        draft.add_detail_box({{1000, y, 36}, {1160, y + 40, 44}}, "wood_planks");
        for (const double x : {1004.0, 1144.0})
            draft.add_detail_box({{x, y + 4, 0}, {x + 12, y + 36, 36}}, "wood_panel");
    }
    draft.add_detail_box({{1020, 8, 44}, {1052, 32, 68}}, "brass_panel");
    draft.add_detail_prism({2, circle(8, 1120, 268, 14, 22.5)}, 44, 76, "copper_roof");
}

}  // namespace

/// What sparks, blinks and glows.
void build_workshop(Draft& draft) {
    const Opening west{Side::West, 96, 192, 0, 112};
    build_room(draft, {{{960, 0, 0}, {1312, 288, 176}},
                       "iron_grate",
                       "wood_planks",
                       {{32, "stone_dark"}, {144, "brick"}, {176, "stone_dark"}},
                       {west}});
    add_dynamo(draft);
    add_broken_lamp(draft, {1090, 144, 112}, 176);
    add_benches(draft);
    add_sign(draft, {Side::South, {1090, 288, 112}, 1, "neon", 128, 32});
    add_wall_lamp(draft, {984, 8, 104}, Side::North, 280);
    draft.add_light({1090, 240, 110}, 270);
    draft.add_light({1030, 100, 130}, 290);
    add_lens(draft, {1180, 144, 0}, "SPARKS");
    add_caption(draft, {{968, 96, 0}, {1000, 192, 72}}, "SPARKS - the neon sign is palette alone.",
                "{frame-cost} lists each effect and its pixels.");
    draft.add_light({1260, 144, 60}, 200);
}

}  // namespace oblong::map_source
