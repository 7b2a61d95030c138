#include "engine/visibility/brush_models.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/visibility/eye.h"

namespace oblong {

namespace {

/// place_eye() keeps the eye clear of the world's planes, not of moving models' planes. A face whose plane is nearer to
/// the eye than this, half a step of World, counts as edge-on and is not drawn.
constexpr auto kEdgeOn = PlaneDistance::from_raw(std::int64_t{1} << 29);

/// A box of a model, at the model's place, rounded outward.
LevelBox moved(LevelBox box, const Vec3<World>& offset) {
    const std::array offsets{offset.x, offset.y, offset.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.mins[axis] = box_coordinate(box.mins[axis] + floor_of(offsets[axis]));
        box.maxs[axis] = box_coordinate(box.maxs[axis] + floor_of(offsets[axis]) + 1);
    }
    return box;
}

/// Whether a node parts a model in two. With a leaf on one side it only bounds it, as those of a convex brush do.
bool parts_model(const Node& node) {
    return !node.children[0].is_leaf() && !node.children[1].is_leaf();
}

/// Ranks the faces of a model at `offset` that face the eye front to back by the model's tree; those that face away,
/// and those of parts outside the view, get -1. `model_sides` are those that the model's box crosses.
void rank_faces(const ModelView& view, const SubModel& model, const Vec3<World>& offset, std::uint8_t model_sides,
                std::vector<ModelStep>& steps, Table<std::int32_t, Face>& ranks) {
    for (const FaceIndex face : model.faces) ranks[face] = -1;
    std::int32_t rank = 0;
    steps.clear();
    const Viewpoint local = view.viewpoint.relative_to(offset);
    const auto descend = [&](NodeChild at, std::uint8_t sides, bool is_part) {
        while (!at.is_leaf()) {
            const Node& node = view.level.nodes[at.node()];
            if (is_part) sides = view.culler.sides_crossed(moved(node.box, offset), sides);
            if (sides == kOutside) return;
            const PlaneDistance distance = plane_distance(view.level.planes[node.plane], local);
            const bool in_front = distance > PlaneDistance{};
            steps.push_back({at.node(), in_front, absolute(distance) >= kEdgeOn, sides});
            is_part = sides != 0 && parts_model(node);
            at = node.children[!in_front];
        }
    };
    descend(model.root, model_sides, false);
    while (!steps.empty()) {
        const ModelStep step = steps.back();
        steps.pop_back();
        const Node& node = view.level.nodes[step.node];
        if (step.shows_faces)
            for (const FaceIndex face : node.faces)
                if (view.level.faces[face].is_back != step.in_front) ranks[face] = rank++;
        descend(node.children[step.in_front], step.sides, step.sides != 0 && parts_model(node));
    }
}

/// The distance of a model's middle, for comparing: squared from an eye, or along the rays of a parallel view.
std::int64_t distance_order(const SubModel& model, const PlacedModel& placed, const Viewpoint& viewpoint) {
    const auto part = [&](std::int32_t low, std::int32_t high, World offset, World from) {
        const std::int64_t middle = (std::int64_t{low} + high) / 2;
        if (viewpoint.is_direction()) return -(middle + floor_of(offset)) * floor_of<12>(from);
        const std::int64_t away = middle + floor_of(widening_difference(offset, from));
        return away * away;
    };
    const Vec3<World>& from = viewpoint.position;
    return part(model.box.mins[0], model.box.maxs[0], placed.offset.x, from.x) +
           part(model.box.mins[1], model.box.maxs[1], placed.offset.y, from.y) +
           part(model.box.mins[2], model.box.maxs[2], placed.offset.z, from.z);
}

}  // namespace

BrushModels::BrushModels(const Level& level) : face_ranks_(level.faces.size(), -1), leaves_(level.leaves.size()) {}

void BrushModels::start_frame(const Level& level, std::span<const PlacedModel> models, const FaceTable& table) {
    ++frame_;
    const auto has_same_place = [](const PlacedModel& a, const PlacedModel& b) {
        return a.model == b.model && a.offset == b.offset;
    };
    if (std::equal(models.begin(), models.end(), placed_.begin(), placed_.end(), has_same_place)) {
        std::copy(models.begin(), models.end(), placed_.begin());
        return;
    }
    placed_.resize(models.size(), {ModelIndex::none(), {}});
    cuts_.resize(models.size());
    orders_.assign(models.size(), {});
    for (const PlacedIndex index : placed_.indices()) {
        const PlacedModel& model = models[index.position()];
        if (!has_same_place(placed_[index], model)) cuts_[index] = cut_model(level, model, index, table);
        placed_[index] = model;
    }
    link_leaves();
}

void BrushModels::link_leaves() {
    std::fill(leaves_.begin(), leaves_.end(), LeafModels{});
    links_.clear();
    trees_.clear();
    for (const ModelCut& cut : cuts_)
        for (const Fragment& fragment : cut.fragments) add_to_leaf(fragment);
}

void BrushModels::add_to_leaf(const Fragment& fragment) {
    const Index<Link> next = std::exchange(leaves_[fragment.leaf].first_link, Index<Link>(links_.count()));
    const bool is_same_model = !next.is_none() && links_[next].fragment->placed == fragment.placed;
    links_.push_back({&fragment, next, is_same_model ? links_[next].next_model : next});
}

const FragmentTree& BrushModels::tree_of(LeafModels& leaf, const Level& level) {
    if (leaf.tree.is_none()) {
        leaf.tree = Index<FragmentTree>(trees_.count());
        Table<Fragment> fragments;
        std::vector<Vec3<World>> corners;
        for (Index<Link> link = leaf.first_link; !link.is_none(); link = links_[link].next) {
            const Fragment& source = *links_[link].fragment;
            const auto polygon = corners_of(source);
            fragments.push_back(source);
            fragments.back().first_corner = static_cast<std::uint32_t>(corners.size());
            fragments.back().tree = leaf.tree;
            corners.insert(corners.end(), polygon.begin(), polygon.end());
        }
        trees_.push_back(build_fragment_tree(level, placed_, std::move(fragments), std::move(corners)));
    }
    return trees_[leaf.tree];
}

void BrushModels::order_model(PlacedIndex placed, const ModelView& view) {
    const PlacedModel& at = placed_[placed];
    const SubModel& model = view.level.models[at.model];
    const LevelBox box = moved(model.box, at.offset);
    const std::uint8_t sides = view.culler.sides_crossed(box, kAllSides);
    orders_[placed] = {frame_, 0, sides == kOutside || !view.may_be_free(box)};
    if (orders_[placed].is_outside) return;
    orders_[placed].distance = distance_order(model, at, view.viewpoint);
    rank_faces(view, model, at.offset, sides, steps_, face_ranks_);
}

bool BrushModels::is_before(const Fragment& a, const Fragment& b) const {
    const std::int64_t distance_a = orders_[a.placed].distance;
    const std::int64_t distance_b = orders_[b.placed].distance;
    if (distance_a != distance_b) return distance_a < distance_b;
    if (a.placed != b.placed) return a.placed < b.placed;
    if (a.face == b.face) return a.first_corner < b.first_corner;
    return face_ranks_[a.face] < face_ranks_[b.face];
}

bool BrushModels::shows_model(PlacedIndex placed, const ModelView& view) {
    const Order& order = orders_[placed];
    if (order.frame != frame_) order_model(placed, view);
    return !order.is_outside;
}

void BrushModels::find_facing(const Fragment& fragment) {
    if (!orders_[fragment.placed].is_outside && face_ranks_[fragment.face] >= 0) found_.push_back(&fragment);
}

void BrushModels::sort_found(std::size_t first) {
    std::sort(found_.begin() + static_cast<std::ptrdiff_t>(first), found_.end(),
              [this](const Fragment* a, const Fragment* b) { return is_before(*a, *b); });
}

void BrushModels::walk_tree(const FragmentTree& tree, Index<FragmentTree::Node> index, const ModelView& view) {
    if (index.is_none()) return;
    const FragmentTree::Node& node = tree.nodes[index];
    const Fragment& on_plane = tree.fragments[node.on_plane.front()];
    const LevelPlane& plane = view.level.planes[view.level.faces[on_plane.face].plane];
    const bool in_front = plane_distance(plane, view.viewpoint.relative_to(offset_of(on_plane))) > PlaneDistance{};
    walk_tree(tree, in_front ? node.front : node.back, view);
    const std::size_t first = found_.size();
    for (const Index<Fragment> fragment : node.on_plane) find_facing(tree.fragments[fragment]);
    if (found_.size() > first + 1) sort_found(first);
    walk_tree(tree, in_front ? node.back : node.front, view);
}

std::span<const Fragment* const> BrushModels::front_to_back_in(LeafIndex leaf, const ModelView& view) {
    found_.clear();
    LeafModels& in_leaf = leaves_[leaf];
    bool any_shows = false;
    for (Index<Link> link = in_leaf.first_link; !link.is_none(); link = links_[link].next_model)
        any_shows |= shows_model(links_[link].fragment->placed, view);
    if (!any_shows) return {};
    if (!links_[in_leaf.first_link].next_model.is_none()) {
        const FragmentTree& tree = tree_of(in_leaf, view.level);
        walk_tree(tree, tree.root, view);
        if (!tree.root.is_none()) return found_;
    }
    for (Index<Link> link = in_leaf.first_link; !link.is_none(); link = links_[link].next)
        find_facing(*links_[link].fragment);
    sort_found(0);
    return found_;
}

}  // namespace oblong
