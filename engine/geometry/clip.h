#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/frustum.h"

namespace oblong {

/// A polygon's corner during clipping. `borders` are the sides of the view on which clipping put it (Outcode's bits):
/// there it projects exactly onto the screen's border, however near to the eye it lies and however coarse its position
/// therefore is. Which sides it is outside of is decided once: a corner that clipping makes on an edge is on the side
/// of a plane that both ends of the edge are on, whatever its rounded position says. So all faces that share an edge,
/// whatever their other corners, keep the same part of it.
struct ClipVertex {
    Vec3<View> position;
    std::uint8_t borders = 0;
    std::uint8_t outcode = 0;       ///< the sides that it is outside of, among those decided
    std::uint8_t undecided = 0xff;  ///< the sides still to be tested by its position
};

/// Two buffers for clipping plane by plane; kept from frame to frame, so that nothing is allocated.
struct ClipScratch {
    std::vector<ClipVertex> polygon, other;
};

/// Where the edge from `inside` to `outside` crosses a plane, given both distances to it. Always computed from the
/// inside vertex: the two faces that share an edge walk it in opposite directions and get the same bits (hard case C2).
Vec3<View> cross_plane(const Vec3<View>& inside, ClipDistance distance_inside, const Vec3<View>& outside,
                       ClipDistance distance_outside);

/// Clips the convex polygon `scratch.polygon` to the planes in `outcodes` (the union of its vertices' outcodes). The
/// result is in `scratch.polygon`, with at most one vertex more for each plane; perhaps empty. Sutherland and
/// Hodgman, "Reentrant polygon clipping", CACM 17 (1974).
void clip_polygon(const Frustum& frustum, unsigned outcodes, ClipScratch& scratch);

/// Clips `in` to one plane, into `out`; corners put on it get `border`, which is also the plane's bit in outcodes. A
/// corner on the plane is inside (hard case C1).
void clip_to_plane(const ClipPlane& plane, std::uint8_t border, const std::vector<ClipVertex>& in,
                   std::vector<ClipVertex>& out);

}  // namespace oblong
