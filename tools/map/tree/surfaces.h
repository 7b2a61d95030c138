#pragma once

#include <map>

#include "tools/map/source/brush.h"
#include "tools/map/tree/portals.h"

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

/// Texels that a lit surface may reach across, as counted in whole steps of 16: a lightmap has at most 16 x 16 samples.
inline constexpr int kMaxExtent = 240;

/// Cuts lit surfaces so that none exceeds kMaxExtent. Throws InputError if that makes more than a level can have.
std::vector<Surface> subdivided(std::vector<Surface> surfaces, const std::vector<TexInfo>& texinfos);

}  // namespace oblong::map
