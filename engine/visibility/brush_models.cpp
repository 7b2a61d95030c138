#include "engine/visibility/brush_models.h"

#include <algorithm>

#include "engine/level/side.h"

namespace oblong {

namespace {

/// A model may come to the eye, or the eye to it, as no plane of the world does (place_eye). A face that the eye is
/// nearer to than this, half a step of World, it may as well be in: so it is edge-on, and shows nothing.
constexpr auto kEdgeOn = PlaneDistance::from_raw(std::int64_t{1} << 29);

/// Gives the model's faces that face the eye their places, nearest first by the model's own tree; the others -1.
void rank_faces(const Level& level, const SubModel& model, const Vec3<World>& local_eye,
                std::vector<std::int32_t>& steps, std::vector<std::int32_t>& ranks) {
    std::fill_n(ranks.begin() + model.first_face, model.face_count, -1);
    std::int32_t rank = 0;
    // A step is a node to enter, or ~node whose near side is done.
    steps.clear();
    if (model.head_nodes[0] >= 0) steps.push_back(model.head_nodes[0]);
    while (!steps.empty()) {
        const std::int32_t step = steps.back();
        steps.pop_back();
        const Node& node = level.nodes[static_cast<std::size_t>(step < 0 ? ~step : step)];
        const PlaneDistance distance = plane_distance(level.planes[static_cast<std::size_t>(node.plane)], local_eye);
        const bool in_front = distance > PlaneDistance{};
        if (step < 0) {
            if (absolute(distance) < kEdgeOn) continue;
            for (std::int32_t face = node.first_face; face < node.first_face + node.face_count; ++face)
                if (level.faces[static_cast<std::size_t>(face)].is_back != in_front)
                    ranks[static_cast<std::size_t>(face)] = rank++;
            continue;
        }
        if (node.children[in_front] >= 0) steps.push_back(node.children[in_front]);
        steps.push_back(~step);
        if (node.children[!in_front] >= 0) steps.push_back(node.children[!in_front]);
    }
}

std::int64_t squared_distance(const SubModel& model, const PlacedModel& placed, const Vec3<World>& eye) {
    const auto part = [](std::int32_t low, std::int32_t high, World offset, World at) {
        const std::int64_t middle = (std::int64_t{low} + high) / 2 + floor_of(widening_difference(offset, at));
        return middle * middle;
    };
    return part(model.box.mins[0], model.box.maxs[0], placed.offset.x, eye.x) +
           part(model.box.mins[1], model.box.maxs[1], placed.offset.y, eye.y) +
           part(model.box.mins[2], model.box.maxs[2], placed.offset.z, eye.z);
}

}  // namespace

BrushModels::BrushModels(const Level& level) : face_ranks_(level.faces.size(), -1), leaves_(level.leaves.size()) {}

void BrushModels::start_frame(const Level& level, std::span<const PlacedModel> models, const FaceTable& table) {
    ++frame_;
    place(level, models, table);
}

void BrushModels::place(const Level& level, std::span<const PlacedModel> models, const FaceTable& table) {
    const bool is_same_set = std::equal(models.begin(), models.end(), placed_.begin(), placed_.end());
    if (is_same_set) return;
    cuts_.resize(models.size());
    orders_.assign(models.size(), {});
    for (std::size_t i = 0; i < models.size(); ++i)
        if (i >= placed_.size() || placed_[i] != models[i])
            cuts_[i] = cut_model(level, models[i], static_cast<std::int32_t>(i), table);
    placed_.assign(models.begin(), models.end());
    link_leaves(table);
}

void BrushModels::link_leaves(const FaceTable& table) {
    std::fill(leaves_.begin(), leaves_.end(), LeafModels{});
    links_.clear();
    trees_.clear();
    for (const ModelCut& cut : cuts_)
        for (const Fragment& fragment : cut.fragments)
            add_to_leaf(fragment, effects_of(table.kinds[static_cast<std::size_t>(fragment.face)]));
}

void BrushModels::add_to_leaf(const Fragment& fragment, EffectSet effects) {
    LeafModels& leaf = leaves_[static_cast<std::size_t>(fragment.leaf)];
    leaf.effects = leaf.effects | effects.with(Effect::BrushModels);
    if (leaf.first_link >= 0)
        leaf.has_several |= links_[static_cast<std::size_t>(leaf.first_link)].fragment->placed != fragment.placed;
    links_.push_back({&fragment, leaf.first_link});
    leaf.first_link = static_cast<std::int32_t>(links_.size()) - 1;
}

const FragmentTree& BrushModels::tree_of(LeafModels& leaf, const Level& level) {
    if (leaf.tree < 0) {
        leaf.tree = static_cast<std::int32_t>(trees_.size());
        std::vector<Fragment> fragments;
        std::vector<Vec3<World>> corners;
        for (std::int32_t link = leaf.first_link; link >= 0; link = links_[static_cast<std::size_t>(link)].next) {
            const Fragment& source = *links_[static_cast<std::size_t>(link)].fragment;
            const auto polygon = corners_of(source);
            fragments.push_back(source);
            fragments.back().first_corner = static_cast<std::uint32_t>(corners.size());
            fragments.back().tree = leaf.tree;
            corners.insert(corners.end(), polygon.begin(), polygon.end());
        }
        trees_.push_back(build_fragment_tree(level, placed_, std::move(fragments), std::move(corners)));
    }
    return trees_[static_cast<std::size_t>(leaf.tree)];
}

void BrushModels::order_model(std::int32_t placed, const Level& level, const Vec3<World>& eye) {
    Order& order = orders_[static_cast<std::size_t>(placed)];
    if (order.frame == frame_) return;
    const PlacedModel& at = placed_[static_cast<std::size_t>(placed)];
    const SubModel& model = level.models[static_cast<std::size_t>(at.model)];
    order = {frame_, squared_distance(model, at, eye)};
    rank_faces(level, model, eye - at.offset, steps_, face_ranks_);
}

bool BrushModels::is_before(const Fragment& a, const Fragment& b) const {
    const std::int64_t distance_a = orders_[static_cast<std::size_t>(a.placed)].squared_distance;
    const std::int64_t distance_b = orders_[static_cast<std::size_t>(b.placed)].squared_distance;
    if (distance_a != distance_b) return distance_a < distance_b;
    if (a.placed != b.placed) return a.placed < b.placed;
    if (a.face == b.face) return a.first_corner < b.first_corner;
    return face_ranks_[static_cast<std::size_t>(a.face)] < face_ranks_[static_cast<std::size_t>(b.face)];
}

void BrushModels::find_facing(const Fragment& fragment, const Level& level, const Vec3<World>& eye) {
    order_model(fragment.placed, level, eye);
    if (face_ranks_[static_cast<std::size_t>(fragment.face)] >= 0) found_.push_back(&fragment);
}

void BrushModels::sort_found(std::size_t first) {
    std::sort(found_.begin() + static_cast<std::ptrdiff_t>(first), found_.end(),
              [this](const Fragment* a, const Fragment* b) { return is_before(*a, *b); });
}

void BrushModels::walk_tree(const FragmentTree& tree, std::int32_t index, const Level& level, const Vec3<World>& eye) {
    if (index < 0) return;
    const FragmentTree::Node& node = tree.nodes[static_cast<std::size_t>(index)];
    const Fragment& on_plane = tree.fragments[node.on_plane.front()];
    const Face& face = level.faces[static_cast<std::size_t>(on_plane.face)];
    const bool in_front =
        plane_distance(level.planes[static_cast<std::size_t>(face.plane)],
                       eye - placed_[static_cast<std::size_t>(on_plane.placed)].offset) > PlaneDistance{};
    walk_tree(tree, in_front ? node.front : node.back, level, eye);
    const std::size_t first = found_.size();
    for (const std::uint32_t fragment : node.on_plane) find_facing(tree.fragments[fragment], level, eye);
    sort_found(first);
    walk_tree(tree, in_front ? node.back : node.front, level, eye);
}

std::span<const Fragment* const> BrushModels::front_to_back_in(std::int32_t leaf, const Level& level,
                                                               const Vec3<World>& eye) {
    found_.clear();
    LeafModels& in_leaf = leaves_[static_cast<std::size_t>(leaf)];
    if (in_leaf.has_several) {
        const FragmentTree& tree = tree_of(in_leaf, level);
        walk_tree(tree, tree.root, level, eye);
        if (tree.root >= 0) return found_;
    }
    for (std::int32_t link = in_leaf.first_link; link >= 0; link = links_[static_cast<std::size_t>(link)].next)
        find_facing(*links_[static_cast<std::size_t>(link)].fragment, level, eye);
    sort_found(0);
    return found_;
}

}  // namespace oblong
