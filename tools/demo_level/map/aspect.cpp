#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"
#include "tools/demo_level/map/room.h"

namespace oblong::map_source {
namespace {

constexpr double kWindowX = 112, kWindowZ = 144, kWindowHalf = 88;

/// The sphere rests on a pedestal before a plain dark wall, lit from the left and above.
void add_sphere(Draft& draft) {
    const Point centre{-112, 352, 128};
    draft.add_detail_prism({2, circle(8, centre.x, centre.y, 44, 22.5)}, 0, 16, "marble_green");
    draft.add_detail_prism({2, circle(8, centre.x, centre.y, 32, 22.5)}, 16, 64, "brass_panel");
    draft.add_detail_prism({2, circle(8, centre.x, centre.y, 40, 22.5)}, 64, 73 + kHairsbreadth, "marble_green");
    draft.add_detail(make_sphere(centre, 1, "plaster_ivory", "plaster_red"));
    draft.add_light({centre.x, centre.y + 84, 70}, 330);  // hidden behind the pedestal: a halo on the wall
    draft.add_light({centre.x - 80, centre.y - 120, 220}, 570);
    draft.add_light({centre.x + 90, centre.y - 60, 60}, 160);
}

}  // namespace

void build_aspect_room(Draft& draft) {
    const Opening entrance{Side::South, -48, 48, 0, 112}, east{Side::East, 368, 464, 0, 112};
    const Opening window{Side::North, kWindowX - kWindowHalf, kWindowX + kWindowHalf, kWindowZ - kWindowHalf,
                         kWindowZ + kWindowHalf};
    build_room(draft, {{{-256, 0, 0}, {256, 512, 288}},
                       "diamond",
                       "wood_planks",
                       {{48, "wood_panel"}, {256, "plaster_night"}, {288, "sand_frieze"}},
                       {entrance, east, window},
                       "sand_wall"});
    add_round_window(draft, kWindowX, kWindowZ, 512, kWindowHalf, 72, "brass_panel");
    add_sphere(draft);
    add_sign(draft, {Side::South, {kWindowX, 512, 260}, 1.625, "sign_aspect", 96, 32});
    add_way_board(draft, {Side::South, {168, 240, 62}, 0.84375, "sign_vanish", 176, 48});
    add_door_frame(draft, Side::West, east, 256);
    for (const double x : {-248.0, 248.0}) {
        add_wall_lamp(draft, {x, 128, 120}, x < 0 ? Side::East : Side::West, 440);
    }
    for (const double x : {4.0, 224.0}) add_wall_lamp(draft, {x, 504, 150}, Side::South, 360);
    add_hanging_lamp(draft, {112, 256, 200}, 288, 400);
    add_lens(draft, {-112, 262, 0}, "ASPECT");
    add_caption(draft, {{-48, 8, 0}, {48, 40, 72}}, "ASPECT - a sphere is round on your screen.",
                "{projection-aspect}, {display-aspect} spoil it; {aspect-guide} measures it.");
}

}  // namespace oblong::map_source
