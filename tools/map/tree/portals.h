#pragma once

#include <functional>
#include <optional>

#include "tools/map/tree/tree.h"

namespace oblong::map {

/// The polygon between two touching leaves, on a node's plane; clockwise seen from the plane's front.
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
    std::vector<LeafPiece> outer;  ///< the leaves' polygons on the sides of the outer box
};

/// All portals of the tree within `outer`, which must enclose all brushes.
Portals find_portals(const Tree& tree, const PlaneList& planes, const Box& outer);

/// Cuts `winding`, a polygon on a plane, into the borders of the leaves under `child` on the plane's front.
std::vector<LeafPiece> pieces_in_leaves(const Tree& tree, const PlaneList& planes, int child, const Winding& winding,
                                        const Plane& plane);

/// Sets the box, an inner point and the contents of every leaf: contents_of(the inner point).
void fill_leaves(Tree& tree, const Portals& portals, const std::function<int(const Point&)>& contents_of);

/// A path from a point inside the level to the void around it.
struct Leak {
    std::size_t start = 0;  ///< index of the starting point
    std::vector<Point> path;
    std::vector<bool> inside;  ///< by start: whether it is sealed from the void
};

/// Narrower gaps are no leaks: brushes that an editor rotated and rounded do not meet exactly.
inline constexpr double kLeastGap = 1.0 / 64;

/// Makes all leaves solid that are reachable from the outer box without passing solid, sky or a gap below kLeastGap. If
/// one of `starts` is reachable, this is a leak: returns the shortest path (in leaves) and leaves the tree unchanged. A
/// start on a wall's surface counts only if no start is certainly inside.
std::optional<Leak> fill_outside(Tree& tree, const PlaneList& planes, const Portals& portals,
                                 const std::vector<Point>& starts);

/// Whether a leaf is left that is neither solid nor sky.
bool has_inside(const Tree& tree);

}  // namespace oblong::map
