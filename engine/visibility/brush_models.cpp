#include "engine/visibility/brush_models.h"

#include <algorithm>

#include "engine/level/side.h"

namespace oblong {

namespace {

/// A model may come to the eye, or the eye to it, as no plane of the world does (place_eye). A face that the eye is
/// nearer to than this, half a step of World, it may as well be in: so it is edge-on, and shows nothing.
constexpr std::int64_t kEdgeOn_42 = std::int64_t{1} << 29;

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
        const std::int64_t distance = plane_distance_42(level.planes[static_cast<std::size_t>(node.plane)], local_eye);
        const bool in_front = distance > 0;
        if (step < 0) {
            if (distance < kEdgeOn_42 && distance > -kEdgeOn_42) continue;
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
        const std::int64_t middle = (std::int64_t{low} + high) / 2 + floor_shift(std::int64_t{offset.raw} - at.raw, 12);
        return middle * middle;
    };
    return part(model.box.mins[0], model.box.maxs[0], placed.offset.x, eye.x) +
           part(model.box.mins[1], model.box.maxs[1], placed.offset.y, eye.y) +
           part(model.box.mins[2], model.box.maxs[2], placed.offset.z, eye.z);
}

}  // namespace

BrushModels::BrushModels(const Level& level)
    : face_ranks_(level.faces.size(), -1), first_links_(level.leaves.size(), -1) {}

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
    link_leaves();
}

void BrushModels::link_leaves() {
    std::fill(first_links_.begin(), first_links_.end(), -1);
    links_.clear();
    for (const ModelCut& cut : cuts_)
        for (const Fragment& fragment : cut.fragments) {
            std::int32_t& first = first_links_[static_cast<std::size_t>(fragment.leaf)];
            links_.push_back({&fragment, first});
            first = static_cast<std::int32_t>(links_.size()) - 1;
        }
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

std::span<const Fragment* const> BrushModels::front_to_back_in(std::int32_t leaf, const Level& level,
                                                               const Vec3<World>& eye) {
    found_.clear();
    for (std::int32_t link = first_links_[static_cast<std::size_t>(leaf)]; link >= 0;
         link = links_[static_cast<std::size_t>(link)].next) {
        const Fragment* fragment = links_[static_cast<std::size_t>(link)].fragment;
        order_model(fragment->placed, level, eye);
        if (face_ranks_[static_cast<std::size_t>(fragment->face)] >= 0) found_.push_back(fragment);
    }
    std::sort(found_.begin(), found_.end(), [&](const Fragment* a, const Fragment* b) { return is_before(*a, *b); });
    return found_;
}

}  // namespace oblong
