#include "tools/map/portals.h"

namespace oblong::map {
namespace {

struct Walk {
    const Tree& tree;
    const PlaneList& planes;
};

void cut_down(const Walk& walk, int child, Winding winding, const Plane& plane, std::vector<LeafPiece>& pieces) {
    while (child >= 0) {
        const TreeNode& node = walk.tree.node(child);
        const Plane& cutter = walk.planes[node.plane];
        SplitWinding parts = split(winding, cutter);
        if (parts.is_on) {
            child = node.children[dot(cutter.normal, plane.normal) > 0 ? 0 : 1];
            continue;
        }
        if (!parts.front.empty() && !parts.back.empty())
            cut_down(walk, node.children[1], std::move(parts.back), plane, pieces);
        child = node.children[parts.front.empty() ? 1 : 0];
        winding = std::move(parts.front.empty() ? parts.back : parts.front);
    }
    pieces.push_back({Tree::leaf_of(child), std::move(winding)});
}

std::array<Plane, 6> inward_sides(const Box& box) {
    std::array<Plane, 6> sides;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        sides[i] = {axis_vector(axis), component(box.mins, axis)};
        sides[i + 3] = {-axis_vector(axis), -component(box.maxs, axis)};
    }
    return sides;
}

Winding clipped_to_all(Winding winding, const std::vector<Plane>& fronts) {
    for (const Plane& front : fronts) {
        if (winding.empty()) break;
        winding = clipped_to_front(winding, front);
    }
    return winding;
}

// `fronts`: the sides of the node's region, facing inward.
void find_node_portals(const Walk& walk, int child, std::vector<Plane>& fronts, std::vector<Portal>& portals) {
    if (child < 0) return;
    const TreeNode& node = walk.tree.node(child);
    const Plane& plane = walk.planes[node.plane];
    const Winding whole = clipped_to_all(whole_plane(plane), fronts);
    if (whole.size() >= 3) {
        for (const LeafPiece& front : pieces_in_leaves(walk.tree, walk.planes, node.children[0], whole, plane)) {
            for (LeafPiece& both :
                 pieces_in_leaves(walk.tree, walk.planes, node.children[1], front.winding, plane.flipped()))
                portals.push_back({child, {front.leaf, both.leaf}, std::move(both.winding)});
        }
    }
    fronts.push_back(plane);
    find_node_portals(walk, node.children[0], fronts, portals);
    fronts.back() = plane.flipped();
    find_node_portals(walk, node.children[1], fronts, portals);
    fronts.pop_back();
}

}  // namespace

Portals find_portals(const Tree& tree, const PlaneList& planes, const Box& outer) {
    const Walk walk{tree, planes};
    const auto sides = inward_sides(outer);
    std::vector<Plane> fronts(sides.begin(), sides.end());
    Portals found;
    for (const Plane& side : sides) {
        const Winding whole = clipped_to_all(whole_plane(side), fronts);
        for (LeafPiece& piece : pieces_in_leaves(tree, planes, tree.root, whole, side))
            found.outer.push_back(std::move(piece));
    }
    find_node_portals(walk, tree.root, fronts, found.portals);
    return found;
}

std::vector<LeafPiece> pieces_in_leaves(const Tree& tree, const PlaneList& planes, int child, const Winding& winding,
                                        const Plane& plane) {
    std::vector<LeafPiece> pieces;
    cut_down({tree, planes}, child, winding, plane, pieces);
    return pieces;
}

}  // namespace oblong::map
