#pragma once

#include <optional>

#include "engine/fixed/arithmetic.h"
#include "engine/level/side.h"

namespace oblong {

/// Calls visit(leaf, entered, place) for each leaf along a line, in order, until one returns true; returns whether one
/// did. `place` is where the line enters the leaf, `entered` the node on whose plane that is, none for the first leaf.
/// The ends are up to 2^18 units apart.
template <class Visit>
bool walk_line(const Level& level, NodeChild at, Vec3<World> from, const Vec3<World>& to,
               std::optional<NodeIndex> entered, const Visit& visit) {
    while (!at.is_leaf()) {
        const NodeIndex index = at.node();
        const Node& node = level.nodes[index];
        const PlaneDistance first = plane_distance(level.planes[node.plane], from),
                            last = plane_distance(level.planes[node.plane], to);
        const bool starts_back = first < PlaneDistance{}, ends_back = last < PlaneDistance{};
        at = node.children[ends_back];
        if (starts_back == ends_back) continue;
        const Vec3<World> middle = between(from, to, first, first - last);
        if (walk_line(level, node.children[starts_back], from, middle, entered, visit)) return true;
        from = middle;
        entered = index;
    }
    return visit(at.leaf(), entered, from);
}

}  // namespace oblong
