#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "engine/level/level.h"
#include "tools/map/source/geometry.h"
#include "tools/map/source/textures.h"

namespace oblong::map {

struct BrushSide {
    PlaneSide plane;   ///< faces outward
    int texinfo = -1;  ///< -1: not drawn
    Winding winding;   ///< clockwise seen from outside
};

/// A convex body of solid, liquid or sky: the space behind all of its sides.
struct Brush {
    std::vector<BrushSide> sides;
    int contents = contents::kSolid;
    bool is_clip = false;       ///< stops only players, and is invisible
    bool is_detail = false;     ///< hides too little to be considered in visible sets, which makes them faster
    bool shows_inside = false;  ///< its faces are drawn on both sides
    int line = 0;               ///< of the map source
    Box box;

    bool has_side(PlaneSide plane) const {
        return std::any_of(sides.begin(), sides.end(), [&](const BrushSide& side) { return side.plane == plane; });
    }
};

/// The plane through a side's three points; it faces outward.
Plane plane_of(const MapSide& side);

/// Reads a brush of the map source; throws InputError, with its line, if its sides enclose no volume.
Brush make_brush(const MapBrush& source, PlaneList& planes, TextureList& textures);

/// Its two halves: what adds to the lists, and what follows from the planes, for which brushes are independent.
Brush start_brush(const MapBrush& source, PlaneList& planes, TextureList& textures);
void complete_brush(Brush& brush, const PlaneList& planes);

/// Sets the windings of the sides, and the box, from the planes; drops redundant sides. False: the volume is empty or
/// infinite.
bool set_windings(Brush& brush, const PlaneList& planes);

/// Returns the part of a polygon that is inside a brush or on its surface, and appends the rest to `outside` in convex
/// pieces: the polygon itself if nothing is inside.
Winding cut_by_brush(const Winding& winding, const Brush& brush, const PlaneList& planes,
                     std::vector<Winding>& outside);

/// The contents of brushes at points; the brushes must outlive it.
class BrushContents {
  public:
    BrushContents(const std::vector<Brush>& brushes, const PlaneList& planes);

    /// The contents of the highest rank, empty if there is none.
    int at(const Point& point) const;

  private:
    static constexpr double kWidth = 256;
    static int cell_of(double x) { return static_cast<int>(std::floor(x / kWidth)); }

    std::map<std::pair<int, int>, std::vector<const Brush*>>
        in_cells_;  // of x and y: so that few are checked for a point
    const PlaneList& planes_;
};

/// The boxes that move through a level, around their origin: players, and large monsters.
inline constexpr Box kPlayerBox{{-16, -16, -24}, {16, 16, 32}};
inline constexpr Box kLargeBox{{-32, -32, -24}, {32, 32, 64}};

/// The brush grown by a box: all positions of the box's origin where the box overlaps the brush (their Minkowski sum,
/// exactly: with the planes that bevel the brush's corners and edges). set_windings() completes it.
Brush expanded(const Brush& brush, const Box& mover, PlaneList& planes);

/// The obstacles of a mover: the grown solid, sky and clip brushes, all as solid. set_windings() completes them.
std::vector<Brush> hull_brushes(const std::vector<Brush>& brushes, const Box& mover, PlaneList& planes);

/// Where brushes overlap, the contents with the higher rank remain.
constexpr int contents_rank(int filling) {
    constexpr std::array kByRank{contents::kEmpty, contents::kLava, contents::kSlime,
                                 contents::kWater, contents::kSky,  contents::kSolid};
    for (std::size_t rank = 0; rank < kByRank.size(); ++rank)
        if (kByRank[rank] == filling) return static_cast<int>(rank);
    return 0;
}

constexpr bool is_liquid(int filling) {
    return contents_rank(filling) >= 1 && contents_rank(filling) <= 3;
}

/// Opaque and impassable: solid and sky.
constexpr bool is_opaque(int filling) {
    return contents_rank(filling) >= 4;
}

/// By the name of a brush's texture: *lava..., *slime..., other *..., sky..., or else solid.
constexpr int contents_of_texture(std::string_view name) {
    if (name.starts_with("*lava")) return contents::kLava;
    if (name.starts_with("*slime")) return contents::kSlime;
    if (name.starts_with("*")) return contents::kWater;
    if (name.starts_with("sky")) return contents::kSky;
    return contents::kSolid;
}

/// Textures that only instruct the compiler: their faces are not drawn.
constexpr bool is_undrawn_texture(std::string_view name) {
    return name == "clip" || name == "skip" || name == "trigger";
}

}  // namespace oblong::map
