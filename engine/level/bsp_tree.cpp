#include "engine/level/bsp_parts.h"

namespace oblong {

namespace {

constexpr std::int32_t kLowestContents = -16;  ///< compilers know more kinds than Quake's game does

std::int32_t check_contents(const LumpReader& in, std::int32_t contents) {
    if (contents >= 0 || contents < kLowestContents)
        in.fail("contents " + std::to_string(contents) + ", expected -16 to -1");
    return contents;
}

std::int32_t check_node_child(const LumpReader& in, const BspFile& file, std::int32_t child) {
    if (child >= 0) return in.check_index(child, file.count(Lump::Nodes), "node");
    in.check_index(-1 - child, file.count(Lump::Leaves), "leaf");
    return child;
}

std::int32_t check_clip_child(const LumpReader& in, const BspFile& file, std::int32_t child) {
    if (child >= 0) return in.check_index(child, file.count(Lump::ClipNodes), "clipnode");
    return check_contents(in, child);
}

/// A level without clipnodes says 0 where their first would be.
std::int32_t read_clip_head(LumpReader& in, const BspFile& file) {
    const std::int32_t head = in.read_i32();
    if (head == 0 && file.count(Lump::ClipNodes) == 0) return contents::kEmpty;
    return check_clip_child(in, file, head);
}

std::int32_t read_float_bound(LumpReader& in, bool is_maximum) {
    const FloatBits value = in.read_float();
    const auto bound = is_maximum ? ceil_to_int(value) : floor_to_int(value);
    if (!bound) in.fail("bound " + describe(value) + ", expected at most 1048576 either way");
    return *bound;
}

/// Compilers store a model's bounds one unit smaller on each side (id's qbsp, writebsp.c: "remove the padding"; so does
/// ericw-tools), and engines spread them (Quake's model.c, Mod_LoadSubmodels): doors travel as far as they are long.
LevelBox spread(LevelBox box) {
    for (std::int32_t& bound : box.mins) --bound;
    for (std::int32_t& bound : box.maxs) ++bound;
    return box;
}

SubModel read_model(LumpReader& in, const BspFile& file) {
    SubModel model;
    model.box = spread(read_box(in, true));
    model.origin = read_world_vector(in);
    model.head_nodes[0] = check_node_child(in, file, in.read_i32());
    for (std::size_t hull = 1; hull < 4; ++hull) model.head_nodes[hull] = read_clip_head(in, file);
    model.visible_leaf_count = in.check_index(in.read_i32(), file.count(Lump::Leaves), "count of visible leaves");
    model.first_face = in.read_i32();
    model.face_count = in.read_i32();
    in.check_range(model.first_face, model.face_count, file.count(Lump::Faces), "faces");
    return model;
}

}  // namespace

LevelBox read_box(LumpReader& in, bool has_floats) {
    LevelBox box;
    for (std::int32_t& bound : box.mins) bound = has_floats ? read_float_bound(in, false) : in.read_i16();
    for (std::int32_t& bound : box.maxs) bound = has_floats ? read_float_bound(in, true) : in.read_i16();
    return box;
}

std::vector<std::int32_t> read_mark_faces(const BspFile& file) {
    LumpReader in(file, Lump::MarkFaces);
    std::vector<std::int32_t> mark_faces(static_cast<std::size_t>(file.count(Lump::MarkFaces)));
    for (std::int32_t& face : mark_faces) face = in.check_index(in.read_index(), file.count(Lump::Faces), "face");
    return mark_faces;
}

std::vector<Node> read_nodes(const BspFile& file) {
    LumpReader in(file, Lump::Nodes);
    const std::int32_t count = file.count(Lump::Nodes);
    std::vector<Node> nodes(static_cast<std::size_t>(count));
    for (Node& node : nodes) {
        node.plane = in.check_index(in.read_i32(), file.count(Lump::Planes), "plane");
        for (std::int32_t& child : node.children) child = check_node_child(in, file, in.read_child(count));
        node.box = read_box(in, file.format.has_float_boxes);
        node.first_face = in.read_index();
        node.face_count = in.read_index();
        in.check_range(node.first_face, node.face_count, file.count(Lump::Faces), "faces");
    }
    return nodes;
}

std::vector<ClipNode> read_clip_nodes(const BspFile& file) {
    LumpReader in(file, Lump::ClipNodes);
    const std::int32_t count = file.count(Lump::ClipNodes);
    std::vector<ClipNode> clip_nodes(static_cast<std::size_t>(count));
    for (ClipNode& node : clip_nodes) {
        node.plane = in.check_index(in.read_i32(), file.count(Lump::Planes), "plane");
        for (std::int32_t& child : node.children) child = check_clip_child(in, file, in.read_child(count));
    }
    return clip_nodes;
}

std::vector<Leaf> read_leaves(const BspFile& file) {
    LumpReader in(file, Lump::Leaves);
    std::vector<Leaf> leaves(static_cast<std::size_t>(file.count(Lump::Leaves)));
    if (leaves.empty()) in.fail("no leaf, expected at least the solid outside");
    for (Leaf& leaf : leaves) {
        leaf.contents = check_contents(in, in.read_i32());
        if (&leaf == leaves.data() && leaf.contents != contents::kSolid)
            in.fail("the first leaf's contents are " + std::to_string(leaf.contents) + ", expected -2 (solid)");
        leaf.visibility_offset = in.read_i32();
        leaf.box = read_box(in, file.format.has_float_boxes);
        leaf.first_mark_face = in.read_index();
        leaf.mark_face_count = in.read_index();
        in.check_range(leaf.first_mark_face, leaf.mark_face_count, file.count(Lump::MarkFaces), "markfaces");
        in.skip(4);  // ambient sounds
    }
    return leaves;
}

std::vector<SubModel> read_models(const BspFile& file) {
    LumpReader in(file, Lump::Models);
    std::vector<SubModel> models(static_cast<std::size_t>(file.count(Lump::Models)));
    if (models.empty()) in.fail("no model, expected at least the world");
    for (SubModel& model : models) model = read_model(in, file);
    return models;
}

}  // namespace oblong
