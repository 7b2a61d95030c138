#include "engine/visibility/visible_set.h"

#include "engine/level/level.h"

namespace oblong {

std::shared_ptr<const VisibleSet::Parents> VisibleSet::parents_in(const Level& level) {
    const auto parents = std::make_shared<Parents>(
        Parents{{level.nodes.size(), NodeIndex::none()}, {level.leaves.size(), NodeIndex::none()}});
    for (const NodeIndex node : level.nodes.indices())
        for (const NodeChild child : level.nodes[node].children)
            (child.is_leaf() ? parents->of_leaves[child.leaf()] : parents->of_nodes[child.node()]) = node;
    return parents;
}

VisibleSet::VisibleSet(const Level& level)
    : parents_(parents_in(level)),
      node_marks_(level.nodes.size()),
      leaf_set_(level.leaves.size()),
      unpacked_(visible_set_size(level)) {}

void VisibleSet::see_from(const Level& level, LeafIndex leaf) {
    if (leaf == seen_from_) return;
    seen_from_ = leaf;
    ++mark_;
    leaf_set_.clear();
    is_from_open_ = level.leaves[leaf].is_open();
    unpack_visible_set(level, is_from_open_ ? leaf : kSolidOutside, unpacked_);
    for (const LeafIndex other : level.visible_leaves())
        if (is_in_set(unpacked_, other)) mark_upward(other);
}

void VisibleSet::mark_upward(LeafIndex leaf) {
    leaf_set_.add(leaf);
    for (NodeIndex node = parents_->of_leaves[leaf]; !node.is_none() && !has_node(node);
         node = parents_->of_nodes[node])
        node_marks_[node] = mark_;
}

}  // namespace oblong
