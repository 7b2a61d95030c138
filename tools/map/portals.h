#pragma once

#include "tools/map/tree.h"

namespace oblong::map {

/// A polygon where two leaves touch, on the plane of a node; clockwise seen from the plane's front.
struct Portal {
    int node = 0;
    std::array<int, 2> leaves{};  ///< in front, behind
    Winding winding;
};

struct LeafPiece {
    int leaf = 0;
    Winding winding;
};

struct Portals {
    std::vector<Portal> portals;
    std::vector<LeafPiece> outer;  ///< where leaves touch the sides of the outer box
};

/// All portals of the tree within `outer`, which has to reach beyond all brushes.
Portals find_portals(const Tree& tree, const PlaneList& planes, const Box& outer);

/// Cuts `winding`, a polygon on a plane, into what borders the leaves under `child` on the plane's front.
std::vector<LeafPiece> pieces_in_leaves(const Tree& tree, const PlaneList& planes, int child, const Winding& winding,
                                        const Plane& plane);

}  // namespace oblong::map
