#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

void furnish(Draft& draft) {
    draft.add_detail_box({{-40, -416, 0}, {40, 0, 1}}, "carpet");
    for (const double y : {-352.0, -224.0, -96.0}) {
        for (const double x : {-104.0, 104.0}) {
            add_column(draft, {x, y, 0}, 224, 16, "marble_ivory");
            add_wall_lamp(draft, {x + (x < 0 ? 26 : -26), y, 112}, x < 0 ? Side::East : Side::West, 330);
        }
    }
    draft.add_detail_box({{66, -174, 0}, {94, -146, 6}}, "brass_trim");
    draft.add_detail_box({{69, -171, 6}, {91, -149, 20}}, "marble_ivory");
    draft.add_point("misc_model", {80, -160, 20},
                    {{"model", "models/armillary.obj"},
                     {"scale", "18"},
                     {"period", "24"},
                     {"shading", "phong"},
                     {"highlight", "100"}});
    add_panel(draft, {Side::South, {{-84, -40, 176}, {84, -32, 218}}, "title", 128, 32});
    add_sign(draft, {Side::South, {0, -32, 145}, 1.125, "sign_museum", 160, 48});
    add_panel(draft, {Side::East, {{-160, -208, 72}, {-154, -112, 168}}, "picture_moon"});
    add_panel(draft, {Side::West, {{154, -208, 72}, {160, -112, 168}}, "picture_eye"});
}

}  // namespace

void build_entrance(Draft& draft) {
    const Opening door{Side::North, -48, 48, 0, 112};
    build_room(draft, {{{-160, -416, 0}, {160, -32, 224}},
                       "stone_floor",
                       "coffer",
                       {{64, "wood_panel"}, {192, "sand_wall"}, {224, "sand_frieze"}},
                       {door}});
    add_arch(draft, 1, {{-48, -32, 0}, {48, 0, 112}}, "sand_wall");
    furnish(draft);
    draft.add_light({0, -96, 180}, 350);
    add_caption(draft, {{-60, -416, 0}, {60, -330, 72}},
                "Find the twelve lenses, one in each exhibit:", "then the tower opens. {help} shows the keys.");
    draft.add_point("info_player_start", {0, -368, 32}, {{"angle", "90"}});
}

}  // namespace oblong::map_source
