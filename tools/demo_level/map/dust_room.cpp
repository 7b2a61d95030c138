#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

/// A square hole in the ceiling up to the sky, and the moon's light that falls through it.
void add_light_shaft(Draft& draft, const Point& middle, double ceiling, double sky) {
    constexpr double kHalf = 48;
    const Point low{middle.x - kHalf, middle.y - kHalf, ceiling}, high{middle.x + kHalf, middle.y + kHalf, sky};
    build_walls(draft, {{low, high}, "", "", {{sky, "stone_dark"}}, {}});
    draft.add_box({{low.x - kWall, low.y - kWall, sky}, {high.x + kWall, high.y + kWall, sky + 16}}, "sky_night");
    draft.add_point("light", {middle.x, middle.y, sky - 8},
                    {{"light", "250"}, {"delay", "3"}, {"mangle", "0 -90 0"}, {"angle", "32"}});
}

/// The ceiling around the hole.
void add_ceiling(Draft& draft, const Box& inside, const Box& hole) {
    const double z = inside.high.z, top = z + kWall;
    const double west = inside.low.x - kWall, east = inside.high.x + kWall;
    const double south = inside.low.y - kWall, north = inside.high.y + kWall;
    draft.add_box({{west, south, z}, {hole.low.x, north, top}}, "stone_dark");
    draft.add_box({{hole.high.x, south, z}, {east, north, top}}, "stone_dark");
    draft.add_box({{hole.low.x, south, z}, {hole.high.x, hole.low.y, top}}, "stone_dark");
    draft.add_box({{hole.low.x, hole.high.y, z}, {hole.high.x, north, top}}, "stone_dark");
}

}  // namespace

/// Dark but for one shaft of light, in which dust hangs over a block of stone.
void build_dust_room(Draft& draft) {
    const Box inside{{288, 0, 0}, {512, 288, 240}};
    const Point middle{400, 144, 120};
    const Opening east{Side::East, 96, 192, 0, 112};
    const std::vector<WallBand> stone{{240, "stone_dark"}};
    build_walls(draft, {inside, "", "", stone, {east}});
    draft.add_box({{272, -16, -16}, {528, 304, 0}}, "stone_floor");
    add_ceiling(draft, inside, {{middle.x - 48, middle.y - 48, 240}, {middle.x + 48, middle.y + 48, 256}});
    add_light_shaft(draft, middle, 240, 336);
    draft.add_detail_prism({2, circle(8, middle.x, middle.y, 44, 22.5)}, 0, 8, "stone_floor");
    draft.add_detail_prism({2, circle(8, middle.x, middle.y, 28, 22.5)}, 8, 40, "marble_ivory");
    draft.add_detail(make_crystal({middle.x, middle.y, 68}, 16, 28, 45, "cube_gold"));
    draft.add_point("misc_dust", middle, {{"size", "80 80 220"}, {"count", "160"}, {"colour", "47"}, {"period", "20"}});
    add_lens(draft, {366, 206, 0}, "DUST");
    add_caption(draft, {{470, 96, 0}, {506, 192, 72}}, "DUST - 160 specks in a shaft of moonlight.",
                "Out of sight they cost nothing: {frame-cost}.");
    for (const double y : {40.0, 248.0}) {
        for (const double x : {328.0, 472.0}) draft.add_light({x, y, 70}, 230);
    }
}

}  // namespace oblong::map_source
