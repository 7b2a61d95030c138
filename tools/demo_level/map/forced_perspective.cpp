#include <cmath>

#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

constexpr double kEast = -288, kWest = -704, kMiddle = 1584;

/// The room narrows from east to west: 320 by 224 units become 112 by 112, and its columns shrink with it, so that it
/// looks three times as long as it is (Borromini's trick in Palazzo Spada).
struct Narrowing {
    double half_width, floor, ceiling;
};

Narrowing at_share(double share) {
    return {160 - 104 * share, 48 * share, 224 - 64 * share};
}

void add_converging_planes(Draft& draft) {
    const Narrowing end = at_share(1);
    const double south = kMiddle - 160, north = kMiddle + 160;
    draft.add(extrude({1, {{kEast, 0}, {kWest, 0}, {kWest, end.floor}}}, south, north, "checker"));
    draft.add(extrude({1, {{kEast, 224}, {kWest, 224}, {kWest, end.ceiling}}}, south, north, "coffer"));
    draft.add(extrude({2, {{kEast, north}, {kWest, north}, {kWest, kMiddle + end.half_width}}}, 0, 224, "sand_wall"));
    draft.add(extrude({2, {{kEast, south}, {kWest, south}, {kWest, kMiddle - end.half_width}}}, 0, 224, "sand_wall"));
}

void add_shrinking_columns(Draft& draft) {
    for (const double share : {0.09, 0.33, 0.54, 0.72, 0.88}) {
        const Narrowing here = at_share(share);
        const double x = std::round(kEast + (kWest - kEast) * share), radius = std::round(18 - 11 * share);
        const double foot = std::floor(here.floor) - 2, height = std::ceil(here.ceiling) + 2 - foot;
        const double off_axis = std::round(here.half_width - 1.6 * radius);
        for (const double y : {kMiddle - off_axis, kMiddle + off_axis}) {
            add_column(draft, {x, y, foot}, height, radius, "marble_ivory");
        }
        draft.add_light({x - 20, kMiddle, here.ceiling - 30}, static_cast<int>(420 - 220 * share));
    }
}

}  // namespace

void build_forced_perspective(Draft& draft) {
    build_room(draft, {{{kWest, kMiddle - 160, 0}, {kEast, kMiddle + 160, 224}},
                       "checker",
                       "coffer",
                       {{224, "sand_wall"}},
                       {{Side::East, 1536, 1632, 0, 112}, {Side::West, 1536, 1632, 48, 160}}});
    add_converging_planes(draft);
    add_shrinking_columns(draft);
    add_lens(draft, {-672, kMiddle, 45}, "FORCED PERSPECTIVE");
    add_caption(draft, {{-320, 1540, 0}, {-292, 1630, 72}},
                "FORCED PERSPECTIVE - the room shrinks:", "it looks three times as long as it is.");
}

}  // namespace oblong::map_source
