#include "tools/map/fill.h"

namespace oblong::map {
namespace {

constexpr int kVoid = -1, kUnreached = -2;

// For each leaf, the portal through which the flood came; kVoid: right from the outer box.
struct Flood {
    std::vector<int> through;
    std::vector<int> order;  // leaves in the order of the flood
};

std::vector<std::vector<int>> portals_by_leaf(const Tree& tree, const std::vector<Portal>& portals) {
    std::vector<std::vector<int>> by_leaf(tree.leaves.size());
    for (std::size_t i = 0; i < portals.size(); ++i) {
        for (const int leaf : portals[i].leaves) by_leaf[static_cast<std::size_t>(leaf)].push_back(static_cast<int>(i));
    }
    return by_leaf;
}

int other_leaf(const Portal& portal, int leaf) {
    return portal.leaves[portal.leaves[0] == leaf ? 1 : 0];
}

void reach_leaf(Flood& flood, const Tree& tree, int leaf, int through) {
    int& known = flood.through[static_cast<std::size_t>(leaf)];
    if (known != kUnreached || is_opaque(tree.leaf(leaf).contents)) return;
    known = through;
    flood.order.push_back(leaf);
}

Flood flood_from_void(const Tree& tree, const Portals& portals) {
    const auto by_leaf = portals_by_leaf(tree, portals.portals);
    Flood flood{std::vector<int>(tree.leaves.size(), kUnreached), {}};
    for (const LeafPiece& piece : portals.outer) reach_leaf(flood, tree, piece.leaf, kVoid);
    for (std::size_t next = 0; next < flood.order.size(); ++next) {
        const int leaf = flood.order[next];
        for (const int through : by_leaf[static_cast<std::size_t>(leaf)]) {
            const Portal& portal = portals.portals[static_cast<std::size_t>(through)];
            if (least_width(portal.winding) >= kLeastGap) reach_leaf(flood, tree, other_leaf(portal, leaf), through);
        }
    }
    return flood;
}

std::vector<Point> path_to_void(const Tree& tree, const Portals& portals, const Flood& flood, const Point& start,
                                int leaf) {
    std::vector<Point> path{start};
    for (int through = flood.through[static_cast<std::size_t>(leaf)]; through != kVoid;
         through = flood.through[static_cast<std::size_t>(leaf)]) {
        const Portal& portal = portals.portals[static_cast<std::size_t>(through)];
        path.push_back(middle(portal.winding));
        leaf = other_leaf(portal, leaf);
    }
    path.push_back(tree.leaf(leaf).inside);
    return path;
}

}  // namespace

void fill_leaves(Tree& tree, const Portals& portals, const std::function<int(const Point&)>& contents_of) {
    std::vector<double> counts(tree.leaves.size(), 0);
    const auto add = [&](int leaf, const Winding& winding) {
        TreeLeaf& grown = tree.leaf(leaf);
        grown.box.add(winding);
        for (const Point& point : winding) grown.inside = grown.inside + point;
        counts[static_cast<std::size_t>(leaf)] += static_cast<double>(winding.size());
    };
    for (const Portal& portal : portals.portals) {
        for (const int leaf : portal.leaves) add(leaf, portal.winding);
    }
    for (const LeafPiece& piece : portals.outer) add(piece.leaf, piece.winding);
    for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
        TreeLeaf& leaf = tree.leaves[i];
        if (counts[i] == 0) continue;
        leaf.inside = scaled(leaf.inside, 1 / counts[i]);
        leaf.contents = contents_of(leaf.inside);
    }
}

std::optional<Leak> fill_outside(Tree& tree, const PlaneList& planes, const Portals& portals,
                                 const std::vector<Point>& starts) {
    const Flood flood = flood_from_void(tree, portals);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const int leaf = leaf_at(tree, planes, starts[i]);
        if (flood.through[static_cast<std::size_t>(leaf)] == kUnreached) continue;
        return Leak{i, path_to_void(tree, portals, flood, starts[i], leaf)};
    }
    for (const int leaf : flood.order) tree.leaf(leaf).contents = contents::kSolid;
    return std::nullopt;
}

}  // namespace oblong::map
