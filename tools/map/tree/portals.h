#pragma once

#include <functional>
#include <optional>

#include "tools/map/tree/tree.h"

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

/// Sets the box, an inner point and the contents of every leaf: contents_of(the inner point).
void fill_leaves(Tree& tree, const Portals& portals, const std::function<int(const Point&)>& contents_of);

/// The way from a point inside the level to the void around it.
struct Leak {
    std::size_t start = 0;  ///< index of the starting point
    std::vector<Point> path;
    std::vector<bool> inside;  ///< which starts are sealed off from the void
};

/// Narrower gaps do not count: brushes that an editor turned and rounded do not meet exactly.
inline constexpr double kLeastGap = 1.0 / 64;

/// Makes all leaves solid that can be reached from the outer box without passing solid, sky or a gap below kLeastGap.
/// If one of `starts` can, that is a leak: the shortest way (in leaves) is returned and the tree is left as it was.
/// A start on a wall's surface is in the wall: it counts only if none is surely inside.
std::optional<Leak> fill_outside(Tree& tree, const PlaneList& planes, const Portals& portals,
                                 const std::vector<Point>& starts);

}  // namespace oblong::map
