#include "tools/map/tree/emit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "engine/base/little_endian.h"

namespace oblong::map {
namespace {

FileBox outward_box(const Box& box) {
    FileBox result;
    if (box.is_empty()) return result;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        result.mins[i] = static_cast<int>(std::floor(box.mins[axis]));
        result.maxs[i] = static_cast<int>(std::ceil(box.maxs[axis]));
    }
    return result;
}

// The common contents of all leaves under a child, 0 if they differ.
int uniform_contents(const Tree& tree, int child) {
    if (child < 0) return tree.leaf(Tree::leaf_of(child)).contents;
    const TreeNode& node = tree.node(child);
    const int front = uniform_contents(tree, node.children[0]);
    return front != 0 && front == uniform_contents(tree, node.children[1]) ? front : 0;
}

// The offset modulo the texture's size, if it is so large that a float would lose parts of texels.
double near_offset(double offset, const std::string& miptex, std::size_t axis) {
    constexpr double kFar = 65536;
    constexpr std::size_t kSizes = 16;  // behind the name
    if (std::abs(offset) <= kFar || miptex.size() < kSizes + 8) return offset;
    const std::uint32_t size =
        little_endian_u32(reinterpret_cast<const std::uint8_t*>(miptex.data()) + kSizes + 4 * axis);
    return size == 0 ? offset : offset - size * std::floor(offset / size);
}

int count(const auto& items) {
    return static_cast<int>(items.size());
}

}  // namespace

// A model's faces and leaves during numbering.
struct Emitter::Numbering {
    std::vector<std::vector<int>> faces_of_leaf;
    std::map<int, std::pair<int, int>> faces_of_node;  // first, count
    std::vector<int> leaf_indices;
};

Emitter::Emitter(BspFile& bsp, const PlaneList& planes) : bsp_(bsp), planes_(planes) {
    bsp_.leaves.push_back({contents::kSolid, -1, {}, 0, 0});
    bsp_.edges.push_back({0, 0});  // edge 0 has no negative
}

std::vector<int> Emitter::add_model(const CompiledModel& model) {
    FileModel numbers;
    if (!model.box.is_empty()) {
        const Box stored = model.box.grown(-1);  // as in id's qbsp: readers expand it again
        numbers.mins = to_floats(stored.mins);
        numbers.maxs = to_floats(stored.maxs);
    }
    numbers.first_face = count(bsp_.faces);
    numbers.face_count = count(model.surfaces);
    Numbering numbering;
    numbering.faces_of_leaf.resize(model.tree.leaves.size());
    numbering.leaf_indices.resize(model.tree.leaves.size());
    mark_faces(model, numbering);
    const int first_vertex = count(bsp_.vertices);
    for (const Point& point : model.vertices.points()) bsp_.vertices.push_back(to_floats(point));
    open_edges_.clear();
    for (const Surface& surface : model.surfaces) add_face(surface, first_vertex);
    const int leaves_before = count(bsp_.leaves);
    Box box;
    numbers.head_nodes[0] = add_child(model, model.tree.root, numbering, box);
    numbers.visible_leaf_count = count(bsp_.leaves) - leaves_before;
    for (std::size_t i = 0; i < model.hulls.size(); ++i)
        numbers.head_nodes[i + 1] = add_clip_child(model.hulls[i], model.hulls[i].root);
    if (model.hulls.size() < 2) numbers.head_nodes[2] = numbers.head_nodes[1];
    bsp_.models.push_back(numbers);
    return std::move(numbering.leaf_indices);
}

void Emitter::add_texinfos(const std::vector<TexInfo>& texinfos) {
    for (const TexInfo& texinfo : texinfos) {
        FileTexInfo numbers;
        for (std::size_t i = 0; i < 2; ++i)
            numbers.axes[i] = {
                to_floats(texinfo.axes[i]),
                static_cast<float>(near_offset(texinfo.offset[i], item(bsp_.textures, texinfo.texture), i))};
        numbers.texture = texinfo.texture;
        numbers.flags = texinfo.is_special ? 1 : 0;
        bsp_.texinfos.push_back(numbers);
    }
}

int Emitter::plane_index(int plane) {
    if (plane_indices_.size() <= static_cast<std::size_t>(plane))
        plane_indices_.resize(static_cast<std::size_t>(planes_.count()), -1);
    int& index = item(plane_indices_, plane);
    if (index >= 0) return index;
    index = count(bsp_.planes);
    const Plane& numbers = planes_[plane];
    bsp_.planes.push_back({to_floats(numbers.normal), static_cast<float>(numbers.distance), planes_.type(plane)});
    return index;
}

void Emitter::add_face(const Surface& surface, int first_vertex) {
    const Loop& loop = surface.loop;
    FileFace face;
    face.plane = plane_index(surface.plane.plane);
    face.is_back = surface.plane.is_back ? 1 : 0;
    face.first_surf_edge = count(bsp_.surf_edges);
    face.edge_count = count(loop);
    face.texinfo = surface.texinfo;
    for (std::size_t i = 0; i < loop.size(); ++i)
        bsp_.surf_edges.push_back(surf_edge(first_vertex + loop[i], first_vertex + loop[(i + 1) % loop.size()]));
    bsp_.faces.push_back(face);
}

// Two faces in opposite directions share an edge.
int Emitter::surf_edge(int from, int to) {
    const auto key = [](int first, int second) {
        return static_cast<std::uint64_t>(first) << 32 | static_cast<std::uint64_t>(second);
    };
    const auto open = open_edges_.find(key(to, from));
    if (open != open_edges_.end()) {
        const int index = open->second;
        open_edges_.erase(open);
        return -index;
    }
    bsp_.edges.push_back({from, to});
    const int index = count(bsp_.edges) - 1;
    open_edges_.insert_or_assign(key(from, to), index);
    return index;
}

void Emitter::mark_faces(const CompiledModel& model, Numbering& numbering) {
    for (std::size_t i = 0; i < model.surfaces.size(); ++i) {
        const Surface& surface = model.surfaces[i];
        const int face = count(bsp_.faces) + static_cast<int>(i);
        const int child = model.tree.node(surface.node).children[surface.plane.is_back ? 1 : 0];
        for (const LeafPiece& piece :
             pieces_in_leaves(model.tree, planes_, child, surface.winding, planes_.facing(surface.plane))) {
            auto& marked = item(numbering.faces_of_leaf, piece.leaf);
            if (marked.empty() || marked.back() != face) marked.push_back(face);
        }
        auto& [first, faces] = numbering.faces_of_node.try_emplace(surface.node, face, 0).first->second;
        ++faces;
    }
}

int Emitter::add_child(const CompiledModel& model, int child, Numbering& numbering, Box& box) {
    if (uniform_contents(model.tree, child) == contents::kSolid) return -1;
    if (child >= 0) return add_node(model, child, numbering, box);
    const int leaf = Tree::leaf_of(child);
    box = model.tree.leaf(leaf).box;
    const auto i = static_cast<std::size_t>(leaf);
    numbering.leaf_indices[i] = add_leaf(model.tree.leaf(leaf), numbering.faces_of_leaf[i]);
    return -1 - numbering.leaf_indices[i];
}

int Emitter::add_node(const CompiledModel& model, int child, Numbering& numbering, Box& box) {
    const TreeNode& node = model.tree.node(child);
    const int index = count(bsp_.nodes);
    FileNode numbers;
    numbers.plane = plane_index(node.plane);
    const auto faces = numbering.faces_of_node.find(child);
    if (faces != numbering.faces_of_node.end()) std::tie(numbers.first_face, numbers.face_count) = faces->second;
    bsp_.nodes.push_back(numbers);
    for (std::size_t side = 0; side < 2; ++side) {
        Box part;
        const int added = add_child(model, node.children[side], numbering, part);
        item(bsp_.nodes, index).children[side] = added;
        box.add(part);
    }
    item(bsp_.nodes, index).box = outward_box(box);
    return index;
}

int Emitter::add_leaf(const TreeLeaf& leaf, const std::vector<int>& faces) {
    FileLeaf numbers;
    numbers.contents = leaf.contents;
    numbers.box = outward_box(leaf.box);
    numbers.first_mark_face = count(bsp_.mark_faces);
    numbers.mark_face_count = count(faces);
    bsp_.mark_faces.insert(bsp_.mark_faces.end(), faces.begin(), faces.end());
    bsp_.leaves.push_back(numbers);
    return count(bsp_.leaves) - 1;
}

int Emitter::add_clip_child(const Tree& hull, int child) {
    const int uniform = uniform_contents(hull, child);
    if (uniform != 0) return uniform;
    const TreeNode& node = hull.node(child);
    const int index = count(bsp_.clip_nodes);
    bsp_.clip_nodes.push_back({plane_index(node.plane), {}});
    for (std::size_t side = 0; side < 2; ++side) {
        const int added = add_clip_child(hull, node.children[side]);
        item(bsp_.clip_nodes, index).children[side] = added;
    }
    return index;
}

}  // namespace oblong::map
