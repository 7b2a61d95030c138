#include <algorithm>

#include "engine/level/bsp_parts.h"

namespace oblong {

namespace {

std::int64_t record_offset(const BspFile& file, Lump lump, std::size_t index) {
    const int size = file.format.record_sizes[static_cast<std::size_t>(lump)];
    return file.range(lump).offset + static_cast<std::int64_t>(index) * size;
}

/// Counts every node's parents; a node whose parents have all been seen passes its depth on to its children. Nodes that
/// never lose all their parents lie on a cycle or below one.
template <class TreeNode>
class TreeCheck {
  public:
    explicit TreeCheck(const std::vector<TreeNode>& nodes)
        : nodes_(nodes), parents_(nodes.size()), depths_(nodes.size(), 1) {
        for_each_child([this](std::size_t, std::size_t child) { ++parents_[child]; });
    }

    std::int32_t parent_count(std::size_t node) const { return parents_[node]; }

    /// The depth of each node below its farthest root; 0 for those on a cycle or below one.
    std::vector<std::int32_t> find_depths() {
        std::vector<std::int32_t> parents_left = parents_;
        std::vector<std::size_t> ready;
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (parents_left[i] == 0) ready.push_back(i);
        for (std::size_t next = 0; next < ready.size(); ++next) pass_depth_on(ready[next], parents_left, ready);
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (parents_left[i] > 0) depths_[i] = 0;
        return depths_;
    }

  private:
    template <class Visit>
    void for_each_child(Visit visit) {
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            for (const std::int32_t child : nodes_[i].children)
                if (child >= 0) visit(i, static_cast<std::size_t>(child));
    }

    void pass_depth_on(std::size_t node, std::vector<std::int32_t>& parents_left, std::vector<std::size_t>& ready) {
        for (const std::int32_t signed_child : nodes_[node].children) {
            if (signed_child < 0) continue;
            const auto child = static_cast<std::size_t>(signed_child);
            depths_[child] = std::max(depths_[child], depths_[node] + 1);
            if (--parents_left[child] == 0) ready.push_back(child);
        }
    }

    const std::vector<TreeNode>& nodes_;
    std::vector<std::int32_t> parents_, depths_;
};

void check_depths(const BspFile& file, Lump lump, const std::vector<std::int32_t>& depths) {
    for (std::size_t i = 0; i < depths.size(); ++i) {
        if (depths[i] == 0)
            fail_in_lump(lump, record_offset(file, lump, i), "on or below a cycle, expected every way down to end");
        if (depths[i] > kMaxTreeDepth)
            fail_in_lump(lump, record_offset(file, lump, i), "over 1024 nodes below its root, expected 1024 at most");
    }
}

/// The packed bytes of a row: a byte that is not 0 stands for itself, a 0 and a count for that many zeros.
std::int64_t packed_row_size(LumpReader& in, std::int64_t start, std::int64_t row_size) {
    in.seek(start);
    std::int64_t packed = 0;
    for (std::int64_t unpacked = 0; unpacked < row_size;) {
        const bool is_run = in.read_u8() == 0;
        unpacked += is_run ? in.read_u8() : 1;
        packed += is_run ? 2 : 1;
    }
    return packed;
}

}  // namespace

void check_node_tree(const BspFile& file, const std::vector<Node>& nodes) {
    TreeCheck<Node> check(nodes);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (check.parent_count(i) > 1)
            fail_in_lump(Lump::Nodes, record_offset(file, Lump::Nodes, i), "child of two nodes, expected one at most");
    check_depths(file, Lump::Nodes, check.find_depths());
}

void check_clip_nodes(const BspFile& file, const std::vector<ClipNode>& clip_nodes) {
    check_depths(file, Lump::ClipNodes, TreeCheck<ClipNode>(clip_nodes).find_depths());
}

void check_visibility(const BspFile& file, const Level& level) {
    LumpReader in(file, Lump::Visibility);
    const std::int64_t row_size = (level.models[0].visible_leaf_count + 7) / 8;
    std::vector<std::int32_t> starts;
    for (std::size_t i = 0; i < level.leaves.size(); ++i) {
        const std::int32_t start = level.leaves[i].visibility_offset;
        if (start == -1) continue;
        if (start < 0 || start > in.size())
            fail_in_lump(Lump::Leaves, record_offset(file, Lump::Leaves, i),
                         describe_bad_index("byte of visibility", start, in.size()));
        starts.push_back(start);
    }
    std::sort(starts.begin(), starts.end());
    starts.erase(std::unique(starts.begin(), starts.end()), starts.end());

    // Rows lie beside each other; a file whose rows overlap over and over is made to waste time.
    std::int64_t work_left = in.size() * 64;
    for (const std::int32_t start : starts) {
        work_left -= packed_row_size(in, start, row_size);
        if (work_left < 0) in.fail("rows of visible leaves overlap, expected them beside each other");
    }
}

}  // namespace oblong
