#pragma once

#include <algorithm>
#include <vector>

#include "tools/map/source/contents.h"
#include "tools/map/source/textures.h"
#include "tools/map/source/winding.h"

namespace oblong::map {

struct BrushSide {
    PlaneSide plane;   ///< faces outward
    int texinfo = -1;  ///< -1: not drawn
    Winding winding;   ///< clockwise seen from outside
};

/// A convex solid (or body of liquid, or of sky): what is behind all of its sides.
struct Brush {
    std::vector<BrushSide> sides;
    int contents = contents::kSolid;
    bool is_clip = false;    ///< stops players, but is neither seen nor in the way of anything else
    bool is_detail = false;  ///< hides too little to bound what is seen from where: for the speed of visible sets
    Box box;

    bool has_side(PlaneSide plane) const {
        return std::any_of(sides.begin(), sides.end(), [&](const BrushSide& side) { return side.plane == plane; });
    }
};

/// Reads a brush of the map source; throws InputError, with its line, if its sides enclose no volume.
Brush make_brush(const MapBrush& source, PlaneList& planes, TextureList& textures);

/// Sets the windings of the sides, and the box, from the planes; drops sides that bound nothing. False: there is no
/// volume, or no end to it.
bool set_windings(Brush& brush, const PlaneList& planes);

/// What the brushes put at a point (contents of the highest rank), empty if there is none.
int contents_at(const std::vector<Brush>& brushes, const PlaneList& planes, const Point& point);

/// The boxes that move through a level, around their origin: players, and large monsters.
inline constexpr Box kPlayerBox{{-16, -16, -24}, {16, 16, 32}};
inline constexpr Box kLargeBox{{-32, -32, -24}, {32, 32, 64}};

/// The brush grown by a box: all places of the box's origin where the box overlaps the brush (their Minkowski sum,
/// exactly: with the planes that bevel the brush's corners and edges).
Brush expanded(const Brush& brush, const Box& mover, PlaneList& planes);

/// What stops a mover: the solid, sky and clip brushes, grown, all as solid.
std::vector<Brush> hull_brushes(const std::vector<Brush>& brushes, const Box& mover, PlaneList& planes);

}  // namespace oblong::map
