#include "tools/map/tree/portals.h"

#include <algorithm>

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
        SplitWinding parts = split(std::move(winding), cutter);
        if (parts.is_on) {
            winding = std::move(parts.front);
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

std::vector<Plane> inward_sides(const Box& box) {
    std::vector<Plane> sides;
    for (int axis = 0; axis < 3; ++axis) sides.push_back({axis_vector(axis), box.mins[axis]});
    for (int axis = 0; axis < 3; ++axis) sides.push_back({-axis_vector(axis), -box.maxs[axis]});
    return sides;
}

Winding clipped_to_all(Winding winding, const std::vector<Plane>& fronts) {
    Winding spare;
    for (const Plane& front : fronts) {
        if (winding.empty()) break;
        clip_to_front(winding, front, spare);
    }
    return winding;
}

// `fronts`: the sides of the node's space, facing inward.
void find_node_portals(const Walk& walk, int child, std::vector<Plane>& fronts, std::vector<Portal>& portals) {
    if (child < 0) return;
    const TreeNode& node = walk.tree.node(child);
    const Plane& plane = walk.planes[node.plane];
    Winding whole = clipped_to_all(whole_plane(plane), fronts);
    if (whole.size() >= 3) {
        std::vector<LeafPiece> in_front, pieces;
        cut_down(walk, node.children[0], std::move(whole), plane, in_front);
        for (LeafPiece& front : in_front) {
            pieces.clear();
            cut_down(walk, node.children[1], std::move(front.winding), plane.flipped(), pieces);
            for (LeafPiece& both : pieces) portals.push_back({child, {front.leaf, both.leaf}, std::move(both.winding)});
        }
    }
    fronts.push_back(plane);
    find_node_portals(walk, node.children[0], fronts, portals);
    fronts.back() = plane.flipped();
    find_node_portals(walk, node.children[1], fronts, portals);
    fronts.pop_back();
}

constexpr int kVoid = -1, kUnreached = -2;

// For each leaf, the portal by which the flood arrived; kVoid: directly from the outer box.
struct Flood {
    std::vector<int> through;
    std::vector<int> order;  // leaves in the order of the flood
};

std::vector<std::vector<int>> portals_by_leaf(const Tree& tree, const std::vector<Portal>& portals) {
    std::vector<std::vector<int>> by_leaf(tree.leaves.size());
    for (std::size_t i = 0; i < portals.size(); ++i)
        for (const int leaf : portals[i].leaves) item(by_leaf, leaf).push_back(static_cast<int>(i));
    return by_leaf;
}

int other_leaf(const Portal& portal, int leaf) {
    return portal.leaves[portal.leaves[0] == leaf ? 1 : 0];
}

bool may_reach(const Flood& flood, const Tree& tree, int leaf) {
    return item(flood.through, leaf) == kUnreached && !is_opaque(tree.leaf(leaf).contents);
}

void reach_leaf(Flood& flood, int leaf, int through) {
    item(flood.through, leaf) = through;
    flood.order.push_back(leaf);
}

Flood flood_from_void(const Tree& tree, const Portals& portals) {
    const auto by_leaf = portals_by_leaf(tree, portals.portals);
    Flood flood{std::vector<int>(tree.leaves.size(), kUnreached), {}};
    for (const LeafPiece& piece : portals.outer)
        if (may_reach(flood, tree, piece.leaf)) reach_leaf(flood, piece.leaf, kVoid);
    for (std::size_t next = 0; next < flood.order.size(); ++next) {
        const int leaf = flood.order[next];
        for (const int through : item(by_leaf, leaf)) {
            const Portal& portal = item(portals.portals, through);
            const int other = other_leaf(portal, leaf);
            if (may_reach(flood, tree, other) && least_width(portal.winding) >= kLeastGap)
                reach_leaf(flood, other, through);
        }
    }
    return flood;
}

// The leaves that contain or touch a point.
struct Touched {
    int reached = -1;  // a leaf reached by the flood
    bool has_inside = false, has_wall = false;
};

Touched touched_at(const Tree& tree, const PlaneList& planes, const Flood& flood, const Point& point) {
    Touched touched;
    for (const int leaf : leaves_at(tree, planes, point)) {
        if (item(flood.through, leaf) != kUnreached) touched.reached = leaf;
        touched.has_wall |= is_opaque(tree.leaf(leaf).contents);
        touched.has_inside |= may_reach(flood, tree, leaf);
    }
    return touched;
}

std::vector<Point> path_to_void(const Tree& tree, const Portals& portals, const Flood& flood, const Point& start,
                                int leaf) {
    std::vector<Point> path{start};
    for (int through = item(flood.through, leaf); through != kVoid; through = item(flood.through, leaf)) {
        const Portal& portal = item(portals.portals, through);
        path.push_back(middle(portal.winding));
        leaf = other_leaf(portal, leaf);
    }
    path.push_back(tree.leaf(leaf).inside);
    return path;
}

}  // namespace

Portals find_portals(const Tree& tree, const PlaneList& planes, const Box& outer) {
    const Walk walk{tree, planes};
    std::vector<Plane> fronts = inward_sides(outer);
    Portals found;
    for (const Plane& side : fronts) {
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

void fill_leaves(Tree& tree, const Portals& portals, const std::function<int(const Point&)>& contents_of) {
    std::vector<double> counts(tree.leaves.size(), 0);
    const auto add = [&](int leaf, const Winding& winding) {
        TreeLeaf& grown = tree.leaf(leaf);
        grown.box.add(winding);
        for (const Point& point : winding) grown.inside = grown.inside + point;
        item(counts, leaf) += static_cast<double>(winding.size());
    };
    for (const Portal& portal : portals.portals)
        for (const int leaf : portal.leaves) add(leaf, portal.winding);
    for (const LeafPiece& piece : portals.outer) add(piece.leaf, piece.winding);
    for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
        TreeLeaf& leaf = tree.leaves[i];
        if (counts[i] == 0) continue;
        leaf.inside = leaf.inside * (1 / counts[i]);
        leaf.contents = contents_of(leaf.inside);
    }
}

bool has_inside(const Tree& tree) {
    return std::any_of(tree.leaves.begin(), tree.leaves.end(),
                       [](const TreeLeaf& leaf) { return !is_opaque(leaf.contents); });
}

std::optional<Leak> fill_outside(Tree& tree, const PlaneList& planes, const Portals& portals,
                                 const std::vector<Point>& starts) {
    const Flood flood = flood_from_void(tree, portals);
    std::optional<Leak> on_wall;
    std::vector<bool> inside(starts.size());
    std::optional<Leak> in_open;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const Touched touched = touched_at(tree, planes, flood, starts[i]);
        inside[i] = touched.has_inside;
        std::optional<Leak>& leak = touched.has_wall ? on_wall : in_open;
        if (touched.has_inside || touched.reached < 0 || leak) continue;
        leak = {i, path_to_void(tree, portals, flood, starts[i], touched.reached), {}};
    }
    const bool is_any_inside = std::count(inside.begin(), inside.end(), true) > 0;
    if (!in_open && !is_any_inside) in_open = std::move(on_wall);
    if (in_open) {
        in_open->inside = std::move(inside);
        return in_open;
    }
    for (const int leaf : flood.order) tree.leaf(leaf).contents = contents::kSolid;
    return std::nullopt;
}

}  // namespace oblong::map
