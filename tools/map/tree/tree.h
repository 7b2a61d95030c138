#pragma once

#include <array>

#include "tools/map/source/brush.h"

namespace oblong::map {

/// A convex piece of the boundary between different contents: input of a tree.
struct BoundaryPiece {
    BoundaryPiece(PlaneSide its_plane, Winding polygon, bool is_of_detail)
        : plane(its_plane), winding(std::move(polygon)), box(box_of(winding)), is_detail(is_of_detail) {}

    PlaneSide plane;
    Winding winding;
    Box box;
    bool is_detail;  ///< its plane is used only after all others
};

/// children: [0] in front of the plane, [1] behind; an index of a node, or -1 - an index of a leaf.
struct TreeNode {
    int plane = 0;
    std::array<int, 2> children{};
    bool is_detail = false;  ///< it and all nodes below it cut only for details
};

struct TreeLeaf {
    int contents = contents::kSolid;
    Box box;       ///< of its part in the level; empty: no part
    Point inside;  ///< a point in it, if the box is not empty
};

/// A binary space partition. A child is a node or a leaf; so is the root.
struct Tree {
    int root = -1;
    std::vector<TreeNode> nodes;
    std::vector<TreeLeaf> leaves;

    const TreeNode& node(int child) const { return item(nodes, child); }
    static int leaf_of(int child) { return -1 - child; }
    TreeLeaf& leaf(int index) { return item(leaves, index); }
    const TreeLeaf& leaf(int index) const { return item(leaves, index); }
};

/// Cuts space by the planes of the pieces until none crosses a leaf. Prefers axial planes that cut few pieces and have
/// equally many on both sides; planes of details are last.
Tree build_tree(std::vector<BoundaryPiece> pieces, const PlaneList& planes);

/// The leaf of a point; points on a plane are in front of it.
int leaf_at(const Tree& tree, const PlaneList& planes, const Point& point);

/// All leaves that contain a point or are within kOnEpsilon of it: on a plane, those on both sides.
std::vector<int> leaves_at(const Tree& tree, const PlaneList& planes, const Point& point);

/// The sides of the brushes without the parts inside other brushes: the boundary of their union, roughly. Where two
/// brushes fill the same space, the contents of higher rank remain, and of equal ranks the later brush.
std::vector<BoundaryPiece> outline(const std::vector<Brush>& brushes, const PlaneList& planes);

}  // namespace oblong::map
