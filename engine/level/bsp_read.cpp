#include "engine/level/bsp_read.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/level/bsp_file.h"
#include "engine/level/entities.h"

namespace oblong {
namespace {

template <class Record>
[[noreturn]] void fail_in_record(const BspFile& file, Lump lump, Index<Record> index, const std::string& what) {
    const std::int64_t size = item(file.format.record_sizes, lump);
    fail_in_lump(lump, file.range(lump).offset + index.number() * size, what);
}

/// Finds depths by topological sorting: a node whose parents have all been visited passes its depth to its children.
/// Nodes that are never visited are on a cycle or below one.
template <class TreeNode>
class TreeCheck {
  public:
    using Counts = Table<std::int32_t, TreeNode>;  ///< one number a node

    explicit TreeCheck(const Table<TreeNode>& nodes) : nodes_(nodes), parents_(nodes.size()), depths_(nodes.size(), 1) {
        for (const TreeNode& node : nodes)
            for (const auto child : node.children)
                if (!child.is_leaf()) ++parents_[child.node()];
    }

    const Counts& parent_counts() const { return parents_; }

    /// The depth of each node below its farthest root; 0 for those on a cycle or below one.
    Counts find_depths() {
        Counts parents_left = parents_;
        std::vector<Index<TreeNode>> ready;
        for (const auto node : nodes_.indices())
            if (parents_left[node] == 0) ready.push_back(node);
        for (std::size_t next = 0; next < ready.size(); ++next) pass_depth_on(ready[next], parents_left, ready);
        for (const auto node : nodes_.indices())
            if (parents_left[node] > 0) depths_[node] = 0;
        return depths_;
    }

  private:
    void pass_depth_on(Index<TreeNode> node, Counts& parents_left, std::vector<Index<TreeNode>>& ready) {
        for (const auto child : nodes_[node].children) {
            if (child.is_leaf()) continue;
            depths_[child.node()] = std::max(depths_[child.node()], depths_[node] + 1);
            if (--parents_left[child.node()] == 0) ready.push_back(child.node());
        }
    }

    const Table<TreeNode>& nodes_;
    Counts parents_, depths_;
};

/// Checks that every path down ends within kMaxTreeDepth steps; subtrees may be shared.
template <class TreeNode>
void check_depths(const BspFile& file, Lump lump, const Table<TreeNode>& nodes) {
    const auto depths = TreeCheck<TreeNode>(nodes).find_depths();
    for (const auto node : nodes.indices()) {
        if (depths[node] == 0) fail_in_record(file, lump, node, "on or below a cycle, expected every way down to end");
        if (depths[node] > kMaxTreeDepth)
            fail_in_record(file, lump, node, "over 1024 nodes below its root, expected 1024 at most");
    }
}

/// The packed size of a row in bytes. A byte that is not 0 is literal; a 0 is followed by a count of zeros.
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

/// The nodes of a model hold its own faces, which are on their planes. Trees share no node.
void check_faces_of_nodes(const BspFile& file, const Level& level, ModelIndex model) {
    const IndexRange<Face> own = level.models[model].faces;
    std::vector<NodeChild> pending{level.models[model].root};
    while (!pending.empty()) {
        const NodeChild at = pending.back();
        pending.pop_back();
        if (at.is_leaf()) continue;
        const Node& node = level.nodes[at.node()];
        for (const FaceIndex face : node.faces)
            if (face < own.first || face.number() >= own.first.number() + own.count)
                fail_in_record(file, Lump::Nodes, at.node(),
                               "face " + std::to_string(face.number()) + " is not among those of model " +
                                   std::to_string(model.number()) + ", expected faces of the node's own model");
            else if (level.faces[face].plane != node.plane)
                fail_in_record(file, Lump::Nodes, at.node(),
                               "face " + std::to_string(face.number()) + " has another plane, expected the node's");
        pending.insert(pending.end(), node.children.begin(), node.children.end());
    }
}

/// Checks that every node has at most one parent, and every path down ends within kMaxTreeDepth steps; that each model
/// has a tree of its own, whose nodes hold its faces, on their planes.
void check_node_tree(const BspFile& file, const Level& level) {
    TreeCheck<Node>::Counts parents = TreeCheck<Node>(level.nodes).parent_counts();
    for (const NodeIndex node : level.nodes.indices())
        if (parents[node] > 1) fail_in_record(file, Lump::Nodes, node, "child of two nodes, expected one at most");
    check_depths(file, Lump::Nodes, level.nodes);
    for (const ModelIndex model : level.models.indices()) {
        // For a brush model without faces, which shows nothing, Quake's qbsp names the next model's first node.
        if (model.number() > 0 && level.models[model].faces.count == 0) continue;
        const NodeChild root = level.models[model].root;
        if (!root.is_leaf() && parents[root.node()]++ > 0)
            fail_in_record(file, Lump::Models, model,
                           "its first node is below another or another model's, expected a tree of its own");
        check_faces_of_nodes(file, level, model);
    }
}

/// Checks that the packed row of each leaf decodes to the world's number of visible leaves, inside the lump.
void check_visibility(const BspFile& file, const Level& level) {
    LumpReader in(file, Lump::Visibility);
    const std::int64_t row_size = (level.world().visible_leaf_count + 7) / 8;
    std::vector<std::int32_t> starts;
    for (const LeafIndex leaf : level.leaves.indices()) {
        const std::int32_t start = level.leaves[leaf].visibility_offset;
        if (start == -1) continue;
        if (start < 0 || start > in.size())
            fail_in_record(file, Lump::Leaves, leaf, describe_bad_index("byte of visibility", start, in.size()));
        starts.push_back(start);
    }
    std::sort(starts.begin(), starts.end());
    starts.erase(std::unique(starts.begin(), starts.end()), starts.end());

    // Rows overlap only in files made to waste time.
    std::int64_t work_left = in.size() * 64;
    for (const std::int32_t start : starts) {
        work_left -= packed_row_size(in, start, row_size);
        if (work_left < 0) in.fail("rows of visible leaves overlap, expected each to have its own bytes");
    }
}

std::vector<std::uint8_t> copy_lump(const BspFile& file, Lump lump) {
    const auto bytes = file.lump_bytes(lump);
    return {bytes.begin(), bytes.end()};
}

std::vector<Entity> read_entities(const BspFile& file) {
    const auto bytes = file.lump_bytes(Lump::Entities);
    const std::string text(bytes.begin(), bytes.end());
    return parse_entities(text, "lump 'entities'", file.range(Lump::Entities).offset);
}

void read_geometry(const BspFile& file, Level& level) {
    level.planes = read_planes(file);
    level.vertices = read_vertices(file);
    level.edges = read_edges(file);
    level.surf_edges = read_surf_edges(file);
    level.textures = read_textures(file);
    for (const TextureIndex texture : level.textures.indices())
        if (level.sky.is_none() && material_of_texture(level.textures[texture].name) == Material::Sky)
            level.sky = texture;
    level.texinfos = read_texinfos(file, level);
    level.faces = read_faces(file, level, read_vertex_floats(file));
    light_flagged_faces(level);
    level.lighting = copy_lump(file, Lump::Lighting);
    level.coloured_lighting = read_coloured_lighting(file);
}

void read_trees(const BspFile& file, Level& level) {
    level.mark_faces = read_mark_faces(file);
    level.nodes = read_nodes(file);
    level.clip_nodes = read_clip_nodes(file);
    level.leaves = read_leaves(file);
    level.models = read_models(file);
    check_node_tree(file, level);
    check_depths(file, Lump::ClipNodes, level.clip_nodes);
}

void read_visibility(const BspFile& file, Level& level) {
    level.visibility = copy_lump(file, Lump::Visibility);
    if (level.visibility.empty())
        for (Leaf& leaf : level.leaves) leaf.visibility_offset = -1;
    check_visibility(file, level);
}

}  // namespace

Level read_bsp(std::span<const std::uint8_t> bytes) {
    const BspFile file = open_bsp(bytes);
    Level level;
    level.entities = read_entities(file);
    read_geometry(file, level);
    read_trees(file, level);
    read_visibility(file, level);
    return level;
}

std::vector<MipTexture> read_bsp_textures(std::span<const std::uint8_t> bytes) {
    const Table<MipTexture> textures = read_textures(open_bsp(bytes));
    return {textures.begin(), textures.end()};
}

}  // namespace oblong
