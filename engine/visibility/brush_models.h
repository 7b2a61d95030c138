#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/level/level.h"
#include "engine/scene/face_table.h"
#include "engine/visibility/fragment_tree.h"

namespace oblong {

/// The brush models of a scene (doors, lifts), cut up by the world's tree so that each part is drawn in front of what
/// lies behind its leaf and behind what lies before it, and where several models stand in one leaf by each other's
/// planes too. A model is cut anew only where it has moved.
class BrushModels {
  public:
    explicit BrushModels(const Level& level);

    /// Starts a frame with the models as they stand now, each model of the level once at the most. Orders are found
    /// anew, and only for models that the frame meets.
    void start_frame(const Level& level, std::span<const PlacedModel> models, const FaceTable& table);

    bool has_any_in(std::int32_t leaf) const { return of_leaf(leaf).first_link >= 0; }
    /// What the parts in a leaf call for.
    EffectSet effects_in(std::int32_t leaf) const { return of_leaf(leaf).effects; }
    /// The parts in a leaf that face the eye, nearest first. Valid until the next call.
    std::span<const Fragment* const> front_to_back_in(std::int32_t leaf, const Level& level, const Vec3<World>& eye);
    std::span<const Vec3<World>> corners_of(const Fragment& fragment) const {
        const std::vector<Vec3<World>>& corners = fragment.tree < 0
                                                      ? cuts_[static_cast<std::size_t>(fragment.placed)].corners
                                                      : trees_[static_cast<std::size_t>(fragment.tree)].corners;
        return std::span(corners).subspan(fragment.first_corner, fragment.corner_count);
    }

  private:
    struct Link {
        const Fragment* fragment;
        std::int32_t next;
    };
    /// What a leaf holds of models.
    struct LeafModels {
        std::int32_t first_link = -1;  ///< -1: nothing
        bool has_several = false;      ///< parts of more than one model
        std::int32_t tree = -1;        ///< of those, made when a frame first meets the leaf
        EffectSet effects;
    };
    /// The order of what one frame meets of a model.
    struct Order {
        std::uint32_t frame = 0;
        std::int64_t squared_distance = 0;
    };

    const LeafModels& of_leaf(std::int32_t leaf) const { return leaves_[static_cast<std::size_t>(leaf)]; }
    void place(const Level& level, std::span<const PlacedModel> models, const FaceTable& table);
    void link_leaves(const FaceTable& table);
    void add_to_leaf(const Fragment& fragment, EffectSet effects);
    const FragmentTree& tree_of(LeafModels& leaf, const Level& level);
    void order_model(std::int32_t placed, const Level& level, const Vec3<World>& eye);
    void find_facing(const Fragment& fragment, const Level& level, const Vec3<World>& eye);
    void sort_found(std::size_t first);
    void walk_tree(const FragmentTree& tree, std::int32_t node, const Level& level, const Vec3<World>& eye);
    /// Which of two parts without a plane between them comes first: that of the nearer model, and within a model as its
    /// own tree orders them.
    bool is_before(const Fragment& a, const Fragment& b) const;

    std::vector<PlacedModel> placed_;
    std::vector<ModelCut> cuts_;  ///< of each placed model
    std::vector<Order> orders_;   ///< of each placed model
    /// Of each face of the level: its place in its model's order; -1: faces away.
    std::vector<std::int32_t> face_ranks_;
    std::vector<LeafModels> leaves_;
    std::vector<FragmentTree> trees_;
    std::vector<Link> links_;
    std::vector<const Fragment*> found_;  ///< what front_to_back_in() returns
    std::vector<std::int32_t> steps_;     ///< scratch of the walk down a model's tree
    std::uint32_t frame_ = 0;
};

}  // namespace oblong
