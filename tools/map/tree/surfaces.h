#pragma once

#include <map>

#include "tools/map/source/brush.h"
#include "tools/map/tree/portals.h"

namespace oblong::map {

/// A polygon as indices of vertices.
using Loop = std::vector<int>;

/// A convex drawn polygon on the plane of a node.
struct Surface {
    int node = 0;
    PlaneSide plane;  ///< the side that it faces
    int texinfo = 0;
    Winding winding;  ///< clockwise seen from its front
    Loop loop = {};   ///< its corners in CompiledModel::vertices
};

/// The polygons between different contents, as planes for another tree; without textures.
std::vector<BoundaryPiece> boundaries(const Tree& tree, const Portals& portals);

/// The drawn polygons: each portal between different contents is covered completely and once by the textures of the
/// brush sides there (liquids, and brushes that say so: on both sides), so the surfaces have no gaps where the tree has
/// none.
std::vector<Surface> make_surfaces(const Tree& tree, const PlaneList& planes, const Portals& portals,
                                   const std::vector<Brush>& brushes);

/// The largest extent of a lit surface in texels, counted in whole steps of 16: a lightmap has at most 16 x 16 samples.
inline constexpr int kMaxExtent = 240;

/// Cuts lit surfaces so that none exceeds kMaxExtent. Throws InputError for more than 262,144 surfaces.
std::vector<Surface> subdivided(std::vector<Surface> surfaces, const std::vector<TexInfo>& texinfos);

}  // namespace oblong::map
