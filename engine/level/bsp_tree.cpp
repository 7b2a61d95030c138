#include <algorithm>

#include "engine/level/bsp_file.h"

namespace oblong {

namespace {

constexpr std::int32_t kLowestContents = -16;  ///< compilers have more kinds than Quake

std::int32_t check_contents(const LumpReader& in, std::int32_t contents) {
    if (contents >= 0 || contents < kLowestContents)
        in.fail("contents " + std::to_string(contents) + ", expected -16 to -1");
    return contents;
}

NodeChild check_node_child(const LumpReader& in, const BspFile& file, std::int32_t child) {
    if (child >= 0) return NodeChild(check_index<Node>(in, child, file, Lump::Nodes, "node"));
    return NodeChild(check_index<Leaf>(in, -1 - child, file, Lump::Leaves, "leaf"));
}

ClipChild check_clip_child(const LumpReader& in, const BspFile& file, std::int32_t child) {
    if (child >= 0) return ClipChild(check_index<ClipNode>(in, child, file, Lump::ClipNodes, "clipnode"));
    return ClipChild(check_contents(in, child));
}

/// A level without clipnodes has 0 as their root.
ClipChild read_clip_root(LumpReader& in, const BspFile& file) {
    const std::int32_t root = in.read_i32();
    if (root == 0 && file.count(Lump::ClipNodes) == 0) return ClipChild(contents::kEmpty);
    return check_clip_child(in, file, root);
}

std::int32_t read_float_bound(LumpReader& in, bool is_maximum) {
    const FloatBits value = in.read_float();
    const auto bound = is_maximum ? ceil_to_int(value) : floor_to_int(value);
    if (!bound) in.fail("bound " + describe(value) + ", expected -1048576 to 1048576");
    return *bound;
}

/// A box of six numbers, mins and maxs, in floats or 16-bit integers.
LevelBox read_box(LumpReader& in, bool has_floats) {
    LevelBox box;
    for (std::int32_t& bound : box.mins) bound = has_floats ? read_float_bound(in, false) : in.read_i16();
    for (std::int32_t& bound : box.maxs) bound = has_floats ? read_float_bound(in, true) : in.read_i16();
    return box;
}

/// The faces of a node or a model; `read` reads numbers of its width.
template <class Read>
IndexRange<Face> read_face_range(const LumpReader& in, const BspFile& file, Read read) {
    const std::int32_t first = read(), count = read();
    return in.check_range<Face>(first, count, file.count(Lump::Faces), "faces");
}

/// Clamps a box to the world; no face is outside.
LevelBox within_world(LevelBox box) {
    for (auto* const corner : {&box.mins, &box.maxs})
        for (LevelNumber& bound : *corner) bound = box_coordinate(bound);
    return box;
}

Node read_node(LumpReader& in, const BspFile& file) {
    Node node;
    node.plane = check_index<LevelPlane>(in, in.read_i32(), file, Lump::Planes, "plane");
    for (NodeChild& child : node.children) child = check_node_child(in, file, in.read_child(file.count(Lump::Nodes)));
    node.box = within_world(read_box(in, file.format.has_float_boxes));
    node.faces = read_face_range(in, file, [&in] { return in.read_index(); });
    return node;
}

ClipNode read_clip_node(LumpReader& in, const BspFile& file) {
    ClipNode node;
    node.plane = check_index<LevelPlane>(in, in.read_i32(), file, Lump::Planes, "plane");
    for (ClipChild& child : node.children)
        child = check_clip_child(in, file, in.read_child(file.count(Lump::ClipNodes)));
    return node;
}

Leaf read_leaf(LumpReader& in, const BspFile& file) {
    Leaf leaf;
    leaf.contents = check_contents(in, in.read_i32());
    leaf.visibility_offset = in.read_i32();
    leaf.box = within_world(read_box(in, file.format.has_float_boxes));
    const std::int32_t first = in.read_index(), count = in.read_index();
    leaf.mark_faces = in.check_range<MarkFace>(first, count, file.count(Lump::MarkFaces), "markfaces");
    in.skip(4);  // ambient sounds
    return leaf;
}

/// Compilers store a model's bounds one unit smaller on each side (id's qbsp, writebsp.c: "remove the padding";
/// ericw-tools), and engines spread them (Quake's model.c, Mod_LoadSubmodels): doors move by their size.
LevelBox spread(LevelBox box) {
    for (std::int32_t& bound : box.mins) --bound;
    for (std::int32_t& bound : box.maxs) ++bound;
    return box;
}

SubModel read_model(LumpReader& in, const BspFile& file) {
    SubModel model;
    model.box = spread(read_box(in, true));
    model.origin = read_world_vector(in);
    model.root = check_node_child(in, file, in.read_i32());
    for (ClipChild& root : model.clip_roots) root = read_clip_root(in, file);
    model.visible_leaf_count = in.check_index(in.read_i32(), file.count(Lump::Leaves), "count of visible leaves");
    model.faces = read_face_range(in, file, [&in] { return in.read_i32(); });
    return model;
}

}  // namespace

Table<FaceIndex, MarkFace> read_mark_faces(const BspFile& file) {
    return read_records<Table<FaceIndex, MarkFace>>(file, Lump::MarkFaces, [&](LumpReader& in) {
        return check_index<Face>(in, in.read_index(), file, Lump::Faces, "face");
    });
}

Table<Node> read_nodes(const BspFile& file) {
    // Nodes share faces, and leaves markfaces, only in files made to waste time.
    std::int64_t work_left = std::int64_t{file.count(Lump::Faces)} * 8;
    return read_records<Table<Node>>(file, Lump::Nodes, [&](LumpReader& in) {
        const Node node = read_node(in, file);
        work_left -= node.faces.count;
        if (work_left < 0) in.fail("nodes share faces, expected each to have its own");
        return node;
    });
}

Table<ClipNode> read_clip_nodes(const BspFile& file) {
    return read_records<Table<ClipNode>>(file, Lump::ClipNodes,
                                         [&](LumpReader& in) { return read_clip_node(in, file); });
}

Table<Leaf> read_leaves(const BspFile& file) {
    if (file.count(Lump::Leaves) == 0)
        LumpReader(file, Lump::Leaves).fail("no leaf, expected at least the solid outside");
    std::int64_t work_left = std::int64_t{file.count(Lump::MarkFaces)} * 8;
    auto leaves = read_records<Table<Leaf>>(file, Lump::Leaves, [&](LumpReader& in) {
        const Leaf leaf = read_leaf(in, file);
        work_left -= leaf.mark_faces.count;
        if (work_left < 0) in.fail("leaves share markfaces, expected each to have its own");
        return leaf;
    });
    if (const std::int32_t found = leaves.front().contents; found != contents::kSolid)
        fail_in_lump(Lump::Leaves, file.range(Lump::Leaves).offset,
                     "the first leaf's contents are " + std::to_string(found) + ", expected -2 (solid)");
    return leaves;
}

Table<SubModel> read_models(const BspFile& file) {
    if (file.count(Lump::Models) == 0) LumpReader(file, Lump::Models).fail("no model, expected at least the world");
    return read_records<Table<SubModel>>(file, Lump::Models, [&](LumpReader& in) { return read_model(in, file); });
}

}  // namespace oblong
