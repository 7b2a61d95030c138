#include "tools/map/tree.h"

#include "tools/map/tree_choose.h"

namespace oblong::map {
namespace {

void add_piece(std::vector<BoundaryPiece>& pieces, const BoundaryPiece& whole, Winding winding) {
    const Box box = box_of(winding);
    pieces.push_back({whole.plane, std::move(winding), box, whole.is_detail});
}

// Pieces on the plane are done with; those across it are cut.
std::array<std::vector<BoundaryPiece>, 2> parted(std::vector<BoundaryPiece> pieces, int plane,
                                                 const PlaneList& planes) {
    std::array<std::vector<BoundaryPiece>, 2> sides;
    for (BoundaryPiece& piece : pieces) {
        const Side side = side_of(piece, plane, planes);
        if (side == Side::kOn) continue;
        if (side == Side::kBoth) {
            SplitWinding parts = split(piece.winding, planes[plane]);
            add_piece(sides[0], piece, std::move(parts.front));
            add_piece(sides[1], piece, std::move(parts.back));
            continue;
        }
        sides[side == Side::kBack ? 1 : 0].push_back(std::move(piece));
    }
    return sides;
}

int build(Tree& tree, std::vector<BoundaryPiece> pieces, const PlaneList& planes) {
    if (pieces.empty()) {
        tree.leaves.emplace_back();
        return -static_cast<int>(tree.leaves.size());
    }
    const int plane = choose_plane(pieces, planes);
    const auto index = tree.nodes.size();
    tree.nodes.push_back({plane, {}, has_only_detail(pieces)});
    auto [front, back] = parted(std::move(pieces), plane, planes);
    const int front_child = build(tree, std::move(front), planes);
    const int back_child = build(tree, std::move(back), planes);
    tree.nodes[index].children = {front_child, back_child};
    return static_cast<int>(index);
}

}  // namespace

Tree build_tree(std::vector<BoundaryPiece> pieces, const PlaneList& planes) {
    Tree tree;
    tree.root = build(tree, std::move(pieces), planes);
    return tree;
}

int leaf_at(const Tree& tree, const PlaneList& planes, const Point& point) {
    int child = tree.root;
    while (child >= 0) {
        const TreeNode& node = tree.node(child);
        child = node.children[planes[node.plane].height_of(point) < 0 ? 1 : 0];
    }
    return Tree::leaf_of(child);
}

}  // namespace oblong::map
