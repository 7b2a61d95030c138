#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/level/level.h"
#include "engine/scene/face_table.h"
#include "engine/view/view_context.h"
#include "engine/visibility/box_culler.h"
#include "engine/visibility/fragments.h"

namespace oblong {

/// What remains to do at a node of a model's tree after its near side.
struct ModelStep {
    NodeIndex node;
    bool in_front;       ///< which side the viewpoint is on
    bool shows_faces;    ///< faces on its plane are not edge-on
    std::uint8_t sides;  ///< of the frustum, that the node's box crosses
};

/// How the brush models of a level are seen: the same in all calls of a frame.
struct ModelView {
    const Level& level;
    const Viewpoint& viewpoint;
    const BoxCuller& culler;
    /// Whether a pixel of a box may be free. Asked once a model and frame.
    const std::function<bool(const LevelBox&)>& may_be_free;
};

/// The brush models of a scene (doors, lifts), split by the world's tree so that each part is drawn with its leaf in
/// front-to-back order. Several models in one leaf are also split by each other's planes. A model is split again only
/// when it has moved.
class BrushModels {
  public:
    explicit BrushModels(const Level& level);

    /// Starts a frame with the models at their current positions, each model of the level at most once. Faces are
    /// ordered later, and only for models that the frame meets.
    void start_frame(const Level& level, std::span<const PlacedModel> models, const FaceTable& table);

    bool has_any_in(LeafIndex leaf) const { return !leaves_[leaf].first_link.is_none(); }
    /// The parts in a leaf that face the viewpoint, nearest first. Models without free pixels in their box, and what is
    /// outside the view, are left out. The result is valid until the next call.
    std::span<const Fragment* const> front_to_back_in(LeafIndex leaf, const ModelView& view);
    std::span<const Vec3<World>> corners_of(const Fragment& fragment) const {
        const auto& corners = fragment.tree.is_none() ? cuts_[fragment.placed].corners : trees_[fragment.tree].corners;
        return std::span(corners).subspan(fragment.first_corner, fragment.corner_count);
    }
    const Vec3<World>& offset_of(const Fragment& fragment) const { return placed_[fragment.placed].offset; }
    /// The same, and zero for null: a face of the world.
    Vec3<World> offset_of(const Fragment* fragment) const { return fragment ? offset_of(*fragment) : Vec3<World>{}; }
    bool is_switched(const Fragment& fragment) const { return placed_[fragment.placed].is_switched; }

  private:
    struct Link {
        const Fragment* fragment;
        Index<Link> next;        ///< in the same leaf
        Index<Link> next_model;  ///< the first one of the leaf's next model
    };
    /// The parts of models in one leaf.
    struct LeafModels {
        Index<Link> first_link = Index<Link>::none();
        Index<FragmentTree> tree = Index<FragmentTree>::none();  ///< of several models, built when one may first show
    };
    /// A model's place in the order of one frame, found when the frame first meets it.
    struct Order {
        std::uint32_t frame = 0;
        std::int64_t distance = 0;  ///< squared, or along the rays of a parallel view: for comparing only
        bool is_outside = false;    ///< outside the view or hidden: its faces have no order
    };

    void link_leaves();
    void add_to_leaf(const Fragment& fragment);
    const FragmentTree& tree_of(LeafModels& leaf, const Level& level);
    void order_model(PlacedIndex placed, const ModelView& view);
    /// Whether a model may show; if so, its faces have an order from then on.
    bool shows_model(PlacedIndex placed, const ModelView& view);
    void find_facing(const Fragment& fragment);
    void sort_found(std::size_t first);
    void walk_tree(const FragmentTree& tree, Index<FragmentTree::Node> node, const ModelView& view);
    /// Whether `a` is drawn before `b` where no plane separates them: the nearer model first, within a model the order
    /// of its tree.
    bool is_before(const Fragment& a, const Fragment& b) const;

    Table<PlacedModel> placed_;
    Table<ModelCut, PlacedModel> cuts_;
    Table<Order, PlacedModel> orders_;
    Table<std::int32_t, Face> face_ranks_;  ///< the face's rank within its model; -1: not shown
    Table<LeafModels, Leaf> leaves_;
    Table<FragmentTree> trees_;
    Table<Link> links_;
    std::vector<const Fragment*> found_;  ///< what front_to_back_in() returns
    std::vector<ModelStep> steps_;        ///< scratch of rank_faces()
    std::uint32_t frame_ = 0;
};

}  // namespace oblong
