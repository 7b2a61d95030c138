#include "tools/demo_level/map/room.h"

#include <algorithm>

namespace oblong::map_source {
namespace {

bool runs_along_x(Side side) {
    return side == Side::North || side == Side::South;
}

/// Where a room's wall stands: north and south walls have the corners.
Box wall_box(const Box& inside, Side side) {
    Box wall = inside;
    if (runs_along_x(side)) {
        wall.low.x -= kWall;
        wall.high.x += kWall;
    }
    switch (side) {
        case Side::North:
            wall.low.y = inside.high.y;
            wall.high.y = inside.high.y + kWall;
            break;
        case Side::South:
            wall.low.y = inside.low.y - kWall;
            wall.high.y = inside.low.y;
            break;
        case Side::East:
            wall.low.x = inside.high.x;
            wall.high.x = inside.high.x + kWall;
            break;
        case Side::West:
            wall.low.x = inside.low.x - kWall;
            wall.high.x = inside.low.x;
            break;
    }
    return wall;
}

/// The part of a wall from `low` to `high` along it and between two heights.
Box wall_part(Box wall, Side side, double low, double high, double z_low, double z_high) {
    (runs_along_x(side) ? wall.low.x : wall.low.y) = low;
    (runs_along_x(side) ? wall.high.x : wall.high.y) = high;
    wall.low.z = z_low;
    wall.high.z = z_high;
    return wall;
}

/// What is left of [low, high] when the openings that span `middle` are cut out: pairs of heights.
std::vector<std::pair<double, double>> solid_heights(const std::vector<Opening>& openings, double middle, double low,
                                                     double high) {
    std::vector<std::pair<double, double>> holes;
    for (const Opening& opening : openings) {
        if (opening.low < middle && middle < opening.high) holes.emplace_back(opening.z_low, opening.z_high);
    }
    std::sort(holes.begin(), holes.end());
    std::vector<std::pair<double, double>> solid;
    for (const auto& [hole_low, hole_high] : holes) {
        if (hole_low > low) solid.emplace_back(low, std::min(hole_low, high));
        low = std::max(low, hole_high);
    }
    if (low < high) solid.emplace_back(low, high);
    return solid;
}

/// A wall's stretch between two cuts, from its foot to its top, band by band.
void build_stretch(Draft& draft, const Room& room, Side side, const std::vector<Opening>& openings, double low,
                   double high) {
    const Box wall = wall_box(room.inside, side);
    double foot = room.inside.low.z;
    const auto skin_of = [&](const std::string& texture) {
        const std::string& ends = room.jambs.empty() ? texture : room.jambs;
        return runs_along_x(side) ? Skin(ends, texture, texture, texture) : Skin(texture, ends, texture, texture);
    };
    for (const WallBand& band : room.walls) {
        for (const auto& [z_low, z_high] : solid_heights(openings, (low + high) / 2, foot, band.z_high)) {
            draft.add_box(wall_part(wall, side, low, high, z_low, z_high), skin_of(band.texture));
        }
        foot = band.z_high;
    }
}

void build_wall(Draft& draft, const Room& room, Side side) {
    std::vector<Opening> openings;
    for (const Opening& opening : room.openings) {
        if (opening.side == side) openings.push_back(opening);
    }
    const Box wall = wall_box(room.inside, side);
    std::vector<double> cuts{runs_along_x(side) ? wall.low.x : wall.low.y,
                             runs_along_x(side) ? wall.high.x : wall.high.y};
    for (const Opening& opening : openings) cuts.insert(cuts.end(), {opening.low, opening.high});
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        if (cuts[i] < cuts[i + 1]) build_stretch(draft, room, side, openings, cuts[i], cuts[i + 1]);
    }
}

}  // namespace

void build_walls(Draft& draft, const Room& room) {
    for (const Side side : {Side::North, Side::East, Side::South, Side::West}) build_wall(draft, room, side);
}

void build_room(Draft& draft, const Room& room) {
    const Point low = room.inside.low, high = room.inside.high;
    const Point outer_low{low.x - kWall, low.y - kWall, low.z - kWall};
    const Point outer_high{high.x + kWall, high.y + kWall, high.z + kWall};
    draft.add_box({outer_low, {outer_high.x, outer_high.y, low.z}}, room.floor);
    draft.add_box({{outer_low.x, outer_low.y, high.z}, outer_high}, room.ceiling);
    build_walls(draft, room);
}

}  // namespace oblong::map_source
