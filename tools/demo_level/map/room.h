#pragma once

#include "tools/demo_level/map/draft.h"

namespace oblong::map_source {

enum class Side { North, East, South, West };

/// Walls, floors and ceilings are this thick; rooms stand two walls apart.
inline constexpr double kWall = 16;

/// A rectangular hole in a wall: from `low` to `high` along it (x for north and south, y for east and west).
struct Opening {
    Side side = Side::North;
    double low = 0, high = 0, z_low = 0, z_high = 0;
};

/// From the height before it up to `z_high` a wall wears this texture.
struct WallBand {
    double z_high = 0;
    std::string texture;
};

struct Room {
    Box inside;
    std::string floor, ceiling;
    std::vector<WallBand> walls;  ///< from the floor up; the last one ends at the ceiling
    std::vector<Opening> openings;
    std::string jambs = {};  ///< of the openings; empty: as their wall
};

/// A closed box with holes. Floor and ceiling go on under the walls, so that doorways have a floor.
void build_room(Draft& draft, const Room& room);

/// The four walls alone.
void build_walls(Draft& draft, const Room& room);

/// A sphere of 24 by 12 facets around `centre`, 112 * `scale` units across (a power of two), its facets of two textures
/// in turn; or of one facet for `coarseness` by `coarseness` of them (1, 2 or 3).
Brush make_sphere(const Point& centre, double scale, const std::string& even_texture, const std::string& odd_texture,
                  std::size_t coarseness = 1);

/// A wall panel of 32 units' depth along y from `y_low`, square, 2 * `half` wide, with a round hole of 24 corners
/// and `radius` in its middle at (x, z).
void add_round_window(Draft& draft, double x, double z, double y_low, double half, double radius, const Skin& skin);

}  // namespace oblong::map_source
