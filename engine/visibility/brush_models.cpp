#include "engine/visibility/brush_models.h"

#include <algorithm>
#include <utility>

#include "engine/level/side.h"

namespace oblong {

namespace {

/// A model may come to the eye, or the eye to it, as no plane of the world does (place_eye). A face that the eye is
/// nearer to than this, half a step of World, it may as well be in: so it is edge-on, and shows nothing.
constexpr std::int64_t kEdgeOn_42 = std::int64_t{1} << 29;

/// Gives the model's faces that face the eye their places, nearest first by the model's own tree; the others -1.
void rank_faces(const Level& level, const SubModel& model, const Vec3<World>& local_eye, std::vector<ModelStep>& steps,
                Table<std::int32_t, Face>& ranks) {
    for (const FaceIndex face : model.faces) ranks[face] = -1;
    std::int32_t rank = 0;
    steps.clear();
    const auto push_child = [&steps](NodeChild child) {
        if (!child.is_leaf()) steps.push_back({child.node()});
    };
    push_child(model.root);
    while (!steps.empty()) {
        const ModelStep step = steps.back();
        steps.pop_back();
        const Node& node = level.nodes[step.node];
        const std::int64_t distance = plane_distance_42(level.planes[node.plane], local_eye);
        const bool in_front = distance > 0;
        if (step.is_entered) {
            if (distance < kEdgeOn_42 && distance > -kEdgeOn_42) continue;
            for (const FaceIndex face : node.faces)
                if (level.faces[face].is_back != in_front) ranks[face] = rank++;
            continue;
        }
        push_child(node.children[in_front]);
        steps.push_back({step.node, true});
        push_child(node.children[!in_front]);
    }
}

std::int64_t squared_distance(const SubModel& model, const PlacedModel& placed, const Vec3<World>& eye) {
    const auto part = [](std::int32_t low, std::int32_t high, World offset, World at) {
        const std::int64_t middle = (std::int64_t{low} + high) / 2 + floor_shift(std::int64_t{offset.raw} - at.raw, 12);
        return middle * middle;
    };
    return part(model.box.mins[0], model.box.maxs[0], placed.offset.x, eye.x) +
           part(model.box.mins[1], model.box.maxs[1], placed.offset.y, eye.y) +
           part(model.box.mins[2], model.box.maxs[2], placed.offset.z, eye.z);
}

}  // namespace

BrushModels::BrushModels(const Level& level)
    : face_ranks_(level.faces.size(), -1), first_links_(level.leaves.size(), Index<Link>::none()) {}

void BrushModels::start_frame(const Level& level, std::span<const PlacedModel> models, const FaceTable& table) {
    ++frame_;
    place(level, models, table);
}

void BrushModels::place(const Level& level, std::span<const PlacedModel> models, const FaceTable& table) {
    const bool is_same_set = std::equal(models.begin(), models.end(), placed_.begin(), placed_.end());
    if (is_same_set) return;
    placed_.resize(models.size(), {ModelIndex::none(), {}});
    cuts_.resize(models.size());
    orders_.assign(models.size(), {});
    for (const PlacedIndex index : placed_.indices()) {
        const PlacedModel& model = models[index.position()];
        if (placed_[index] != model) cuts_[index] = cut_model(level, model, index, table);
        placed_[index] = model;
    }
    link_leaves();
}

void BrushModels::link_leaves() {
    std::fill(first_links_.begin(), first_links_.end(), Index<Link>::none());
    links_.clear();
    for (const ModelCut& cut : cuts_)
        for (const Fragment& fragment : cut.fragments) {
            Index<Link>& first = first_links_[fragment.leaf];
            links_.push_back({&fragment, std::exchange(first, Index<Link>(links_.count()))});
        }
}

void BrushModels::order_model(PlacedIndex placed, const Level& level, const Vec3<World>& eye) {
    Order& order = orders_[placed];
    if (order.frame == frame_) return;
    const PlacedModel& at = placed_[placed];
    const SubModel& model = level.models[at.model];
    order = {frame_, squared_distance(model, at, eye)};
    rank_faces(level, model, eye - at.offset, steps_, face_ranks_);
}

bool BrushModels::is_before(const Fragment& a, const Fragment& b) const {
    const std::int64_t distance_a = orders_[a.placed].squared_distance;
    const std::int64_t distance_b = orders_[b.placed].squared_distance;
    if (distance_a != distance_b) return distance_a < distance_b;
    if (a.placed != b.placed) return a.placed < b.placed;
    if (a.face == b.face) return a.first_corner < b.first_corner;
    return face_ranks_[a.face] < face_ranks_[b.face];
}

std::span<const Fragment* const> BrushModels::front_to_back_in(LeafIndex leaf, const Level& level,
                                                               const Vec3<World>& eye) {
    found_.clear();
    for (Index<Link> link = first_links_[leaf]; !link.is_none(); link = links_[link].next) {
        const Fragment* fragment = links_[link].fragment;
        order_model(fragment->placed, level, eye);
        if (face_ranks_[fragment->face] >= 0) found_.push_back(fragment);
    }
    std::sort(found_.begin(), found_.end(), [&](const Fragment* a, const Fragment* b) { return is_before(*a, *b); });
    return found_;
}

}  // namespace oblong
