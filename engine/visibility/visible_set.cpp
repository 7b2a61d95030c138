#include "engine/visibility/visible_set.h"

#include "engine/level/pvs.h"

namespace oblong {

VisibleSet::VisibleSet(const Level& level)
    : node_parents_(level.nodes.size(), -1),
      leaf_parents_(level.leaves.size(), -1),
      node_marks_(level.nodes.size()),
      leaf_marks_(level.leaves.size()),
      unpacked_(visible_set_size(level)) {
    for (std::size_t node = 0; node < level.nodes.size(); ++node) {
        for (const std::int32_t child : level.nodes[node].children) {
            auto& parents = child >= 0 ? node_parents_ : leaf_parents_;
            parents[static_cast<std::size_t>(child >= 0 ? child : -1 - child)] = static_cast<std::int32_t>(node);
        }
    }
    leaves_.reserve(level.leaves.size());
}

void VisibleSet::see_from(const Level& level, std::int32_t leaf) {
    if (leaf == seen_from_) return;
    seen_from_ = leaf;
    ++mark_;
    leaves_.clear();
    const std::int32_t fills = level.leaves[static_cast<std::size_t>(leaf)].contents;
    is_from_open_ = fills != contents::kSolid && fills != contents::kSky;
    unpack_visible_set(level, is_from_open_ ? leaf : 0, unpacked_);
    for (std::int32_t other = 1; other <= level.models[0].visible_leaf_count; ++other)
        if (is_in_set(unpacked_, other)) mark_upward(other);
}

void VisibleSet::mark_upward(std::int32_t leaf) {
    leaves_.push_back(leaf);
    leaf_marks_[static_cast<std::size_t>(leaf)] = mark_;
    std::int32_t node = leaf_parents_[static_cast<std::size_t>(leaf)];
    for (; node >= 0 && !has_node(node); node = node_parents_[static_cast<std::size_t>(node)])
        node_marks_[static_cast<std::size_t>(node)] = mark_;
}

}  // namespace oblong
