#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

constexpr int kCandle = 3, kOtherCandle = 7;  // light styles

/// Glass over the middle of the south wall, in a frame.
void add_mirror(Draft& draft) {
    const Box glass{{624, 0, 16}, {848, 4, 144}};
    add_panel(draft, {Side::North, glass, "mirror_hall"});
    add_door_frame(draft, Side::North, {Side::South, glass.low.x, glass.high.x, 8, glass.high.z}, 0);
    draft.add_box({{616, 0, 8}, {856, 6, 16}}, "brass_trim");
}

/// A lantern on its way around the middle of the room, and plants that throw a shadow.
void add_what_moves_and_shades(Draft& draft) {
    draft.add_point("misc_lantern", {736, 144, 72},
                    {{"radius", "72"}, {"period", "8"}, {"light", "200"}, {"texture", "{lantern"}, {"scale", "0.75"}});
    for (const double x : {580.0, 892.0}) {
        for (const double y : {40.0, 248.0}) {
            draft.add_point("misc_sprite", {x, y, 32}, {{"texture", "{fern"}, {"scale", "1"}, {"shadow", "22"}});
        }
    }
}

}  // namespace

/// A mirror, a light that moves, candles and shadows.
void build_light_hall(Draft& draft) {
    const Opening west{Side::West, 96, 192, 0, 112}, east{Side::East, 96, 192, 0, 112};
    build_room(draft, {{{544, 0, 0}, {928, 288, 192}},
                       "checker",
                       "coffer",
                       {{32, "wood_panel"}, {160, "plaster_night"}, {192, "sand_frieze"}},
                       {west, east, {Side::North, 688, 784, 0, 112}},
                       "sand_wall"});
    add_arch(draft, 1, {{688, 288, 0}, {784, 320, 112}}, "sand_wall");
    add_mirror(draft);
    add_what_moves_and_shades(draft);
    for (const double x : {568.0, 904.0}) {
        for (const double y : {24.0, 264.0})
            add_column(draft, {x + (x < 700 ? -6 : 6), y + (y < 100 ? -6 : 6), 0}, 192, 12, "marble_ivory");
    }
    add_door_frame(draft, Side::East, west, 544);
    add_door_frame(draft, Side::West, east, 928);
    add_sign(draft, {Side::East, {544, 144, 140}, 1.25, "sign_dust", 64, 32});
    add_sign(draft, {Side::West, {928, 144, 140}, 1.25, "sign_sparks", 96, 32});
    for (const double y : {8.0, 280.0}) {
        const Side facing = y < 144 ? Side::North : Side::South;
        add_wall_lamp(draft, {y < 144 ? 596.0 : 640.0, y, 96}, facing, 330, kCandle);
        add_wall_lamp(draft, {y < 144 ? 876.0 : 832.0, y, 96}, facing, 330, kOtherCandle);
    }
    for (const double x : {640.0, 832.0}) draft.add_light({x, 120, 150}, 330);
    add_lens(draft, {736, 40, 0}, "LIGHT AND SHADOW");
    add_caption(draft, {{688, 240, 0}, {784, 280, 72}}, "LIGHT - a mirror, and a lantern that moves.",
                "{torch} carries a torch; {frame-cost} shows what it costs.");
}

}  // namespace oblong::map_source
