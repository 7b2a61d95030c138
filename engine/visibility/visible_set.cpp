#include "engine/visibility/visible_set.h"

#include "engine/level/pvs.h"

namespace oblong {

VisibleSet::VisibleSet(const Level& level)
    : node_parents_(level.nodes.size(), NodeIndex::none()),
      leaf_parents_(level.leaves.size(), NodeIndex::none()),
      node_marks_(level.nodes.size()),
      leaf_set_(level.leaves.size()),
      unpacked_(visible_set_size(level)) {
    for (const NodeIndex node : level.nodes.indices())
        for (const NodeChild child : level.nodes[node].children)
            (child.is_leaf() ? leaf_parents_[child.leaf()] : node_parents_[child.node()]) = node;
    leaves_.reserve(level.leaves.size());
}

void VisibleSet::see_from(const Level& level, LeafIndex leaf) {
    if (leaf == seen_from_) return;
    seen_from_ = leaf;
    ++mark_;
    leaf_set_.clear();
    leaves_.clear();
    const std::int32_t fills = level.leaves[leaf].contents;
    is_from_open_ = fills != contents::kSolid && fills != contents::kSky;
    unpack_visible_set(level, is_from_open_ ? leaf : kSolidOutside, unpacked_);
    for (const LeafIndex other : level.visible_leaves())
        if (is_in_set(unpacked_, other)) mark_upward(other);
}

void VisibleSet::mark_upward(LeafIndex leaf) {
    leaves_.push_back(leaf);
    leaf_set_.add(leaf);
    for (NodeIndex node = leaf_parents_[leaf]; !node.is_none() && !has_node(node); node = node_parents_[node])
        node_marks_[node] = mark_;
}

}  // namespace oblong
