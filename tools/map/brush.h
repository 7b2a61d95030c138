#pragma once

#include <vector>

#include "tools/map/contents.h"
#include "tools/map/textures.h"
#include "tools/map/winding.h"

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
};

/// Reads a brush of the map source; throws InputError, with its line, if its sides enclose no volume.
Brush make_brush(const MapBrush& source, PlaneList& planes, TextureList& textures);

/// Sets the windings of the sides, and the box, from the planes; drops sides that bound nothing. False: there is no
/// volume, or no end to it.
bool set_windings(Brush& brush, const PlaneList& planes);

/// Whether the point is inside, or within `slack` of it.
bool contains(const Brush& brush, const PlaneList& planes, const Point& point, double slack = 0);

/// What the brushes put at a point (contents of the highest rank), empty if there is none.
int contents_at(const std::vector<Brush>& brushes, const PlaneList& planes, const Point& point);

}  // namespace oblong::map
