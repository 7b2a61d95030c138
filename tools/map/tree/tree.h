#pragma once

#include <array>

#include "tools/map/source/brush.h"

namespace oblong::map {

/// A convex piece of the boundary between different contents: what a tree has to separate.
struct BoundaryPiece {
    PlaneSide plane;
    Winding winding;
    Box box;
    bool is_detail = false;  ///< cut by it only when nothing else is left
};

/// The sides of the brushes without the parts inside other brushes: the boundary of their union, roughly. Where two
/// brushes fill the same space, the contents of higher rank stay, and of equal ones the later brush.
std::vector<BoundaryPiece> outline(const std::vector<Brush>& brushes, const PlaneList& planes);

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

    const TreeNode& node(int child) const { return item(nodes, child); }
    static int leaf_of(int child) { return -1 - child; }
    TreeLeaf& leaf(int index) { return item(leaves, index); }
    const TreeLeaf& leaf(int index) const { return item(leaves, index); }
};

/// Cuts space by the planes of the pieces until none crosses a leaf. Prefers planes that cut few pieces, leave as many
/// on either side, and are axial; planes of detail come last.
Tree build_tree(std::vector<BoundaryPiece> pieces, const PlaneList& planes);

/// The leaf that a point is in; on a plane counts as in front.
int leaf_at(const Tree& tree, const PlaneList& planes, const Point& point);

/// All leaves that a point is in or within kOnEpsilon of: on a plane, those on both sides.
std::vector<int> leaves_at(const Tree& tree, const PlaneList& planes, const Point& point);

}  // namespace oblong::map
