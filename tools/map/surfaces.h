#pragma once

#include "tools/map/portals.h"

namespace oblong::map {

/// A convex drawn polygon on the plane of a node.
struct Surface {
    int node = 0;
    PlaneSide plane;  ///< the side that it faces
    int texinfo = 0;
    Winding winding;  ///< clockwise seen from its front
};

/// The polygons where contents change, as planes for another tree; without textures.
std::vector<BoundaryPiece> boundaries(const Tree& tree, const Portals& portals);

/// What is drawn: each portal between different contents is covered, wholly and once, by the textures of the brush
/// sides that lie there (liquids: on both sides). So the surfaces are as tight as the tree.
std::vector<Surface> make_surfaces(const Tree& tree, const PlaneList& planes, const Portals& portals,
                                   const std::vector<Brush>& brushes);

}  // namespace oblong::map
