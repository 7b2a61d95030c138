#pragma once

#include <array>

#include "tools/map/csg.h"

namespace oblong::map {

/// children: [0] in front of the plane, [1] behind; an index of a node, or -1 - an index of a leaf.
struct TreeNode {
    int plane = 0;
    std::array<int, 2> children{};
    bool is_detail = false;  ///< cuts for detail only, as all below it
};

struct TreeLeaf {
    int contents = contents::kSolid;
    Box box;       ///< of what of it lies in the level; empty: none of it
    Point inside;  ///< a point in it, if the box is not empty
};

/// A binary space partition. A child that is no node is a leaf; the root is a child, too.
struct Tree {
    int root = -1;
    std::vector<TreeNode> nodes;
    std::vector<TreeLeaf> leaves;

    const TreeNode& node(int child) const { return nodes[static_cast<std::size_t>(child)]; }
    static int leaf_of(int child) { return -1 - child; }
    TreeLeaf& leaf(int index) { return leaves[static_cast<std::size_t>(index)]; }
    const TreeLeaf& leaf(int index) const { return leaves[static_cast<std::size_t>(index)]; }
};

/// Cuts space by the planes of the pieces until none crosses a leaf. Prefers planes that cut few pieces, leave as many
/// on either side, and are axial; planes of detail come last.
Tree build_tree(std::vector<BoundaryPiece> pieces, const PlaneList& planes);

/// The leaf that a point is in; on a plane counts as in front.
int leaf_at(const Tree& tree, const PlaneList& planes, const Point& point);

}  // namespace oblong::map
