#include <cmath>

#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

const Point kCourtLow{1184, 1408, -48}, kCourtHigh{1600, 1824, 400};
constexpr double kWalk = 96, kRoofLow = 160, kRoofHigh = 176;

/// The part of the court that a walk of this width leaves in its middle.
Box within_walk(double width, double z_low, double z_high) {
    return {{kCourtLow.x + width, kCourtLow.y + width, z_low}, {kCourtHigh.x - width, kCourtHigh.y - width, z_high}};
}

/// A frame of four boxes between an outer and an inner rectangle, both with the z of `outer`.
void add_frame(Draft& draft, const Box& outer, const Box& inner, const Skin& skin) {
    const double low = outer.low.z, high = outer.high.z;
    draft.add_box({outer.low, {inner.low.x, outer.high.y, high}}, skin);
    draft.add_box({{inner.high.x, outer.low.y, low}, outer.high}, skin);
    draft.add_box({{inner.low.x, outer.low.y, low}, {inner.high.x, inner.low.y, high}}, skin);
    draft.add_box({{inner.low.x, inner.high.y, low}, {inner.high.x, outer.high.y, high}}, skin);
}

/// A floor around a basin that takes up the rain, a step down all around.
void add_basin(Draft& draft) {
    const Box basin = within_walk(kWalk + 40, -48, 0);
    add_frame(draft, within_walk(-kWall, -48, 0), basin, {"basin_tiles", "basin_tiles", "stone_floor", "basin_tiles"});
    add_frame(draft, basin, within_walk(kWalk + 56, -48, 0),
              {"basin_tiles", "basin_tiles", "marble_green", "basin_tiles"});
    draft.add_box({{basin.low.x + 16, basin.low.y + 16, -48}, {basin.high.x - 16, basin.high.y - 16, -10}}, "*water");
}

void add_columns_around(Draft& draft) {
    const Box open = within_walk(kWalk - 16, 0, kRoofLow);
    const double step = (open.high.x - open.low.x) / 2;
    for (int i = 0; i <= 2; ++i) {
        for (int j = 0; j <= 2; ++j) {
            if (i == 1 && j == 1) continue;
            add_column(draft, {std::round(open.low.x + i * step), std::round(open.low.y + j * step), 0}, kRoofLow, 10,
                       "marble_ivory");
        }
    }
}

void add_court_lamps(Draft& draft) {
    for (const double x : {1288.0, 1496.0}) {
        add_wall_lamp(draft, {x, kCourtLow.y + 8, 104}, Side::North, 340);
        add_wall_lamp(draft, {x, kCourtHigh.y - 8, 104}, Side::South, 340);
    }
    for (const double y : {1512.0, 1720.0}) {
        add_wall_lamp(draft, {kCourtLow.x + 8, y, 104}, Side::East, 340);
        add_wall_lamp(draft, {kCourtHigh.x - 8, y, 104}, Side::West, 340);
    }
    draft.add_light({1392, 1616, 60}, 250);
    for (const double x : {1320.0, 1464.0}) {
        for (const double y : {1544.0, 1688.0}) draft.add_light({x, y, 290}, 420);
    }
}

}  // namespace

/// A walk under a roof around an open court, in which it rains.
void build_rain_court(Draft& draft) {
    build_room(draft,
               {{kCourtLow, kCourtHigh},
                "basin_tiles",
                "sky_night",
                {{0, "basin_tiles"}, {32, "stone_dark"}, {224, "sand_wall"}, {256, "sand_frieze"}, {400, "sky_night"}},
                {{Side::West, 1568, 1664, 0, 112}, {Side::North, 1344, 1440, 0, 112}}});
    add_basin(draft);
    add_columns_around(draft);
    add_frame(draft, within_walk(0, kRoofLow, kRoofHigh), within_walk(kWalk, kRoofLow, kRoofHigh),
              {"sand_frieze", "sand_frieze", "copper_roof", "wood_planks"});
    add_court_lamps(draft);
    add_sign(draft, {Side::South, {1392, kCourtHigh.y, 138}, 1, "sign_fog", 64, 32});
    add_lens(draft, {1392, 1522, 0}, "RAIN");
    add_caption(draft, {{1192, 1568, 0}, {1224, 1664, 72}}, "RAIN - 500 drops, drawn in this court alone.",
                "{frame-cost}: they come and go as you turn.");
    const Box rain = within_walk(kWalk + 8, -8, kCourtHigh.z);
    const auto size = std::to_string(static_cast<int>(rain.high.x - rain.low.x));
    draft.add_point("misc_rain", rain.centre(),
                    {{"size", size + ' ' + size + " 400"}, {"count", "500"}, {"colour", "25 30"}});
}

}  // namespace oblong::map_source
