#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/level/level.h"
#include "engine/view/texture_gradients.h"
#include "engine/view/view_context.h"
#include "engine/visibility/box_culler.h"
#include "engine/visibility/brush_models.h"
#include "engine/visibility/span_buffer.h"
#include "engine/visibility/visible_set.h"

namespace oblong {

/// What remains to do at a node after its near side, in this order; in a second walk BackFacing comes before FarSide,
/// if the node has faces.
struct WalkStep {
    enum class Next : std::uint8_t { FrontFacing, FarSide, BackFacing };

    NodeIndex node;
    Next next;               ///< the faces on its plane that face the eye, its far side, those that face away
    bool in_front;           ///< the eye is in front of its plane
    bool takes_back_facing;  ///< whether BackFacing follows FarSide
    std::uint8_t sides;      ///< of the frustum, that the node's box crosses
    bool may_reach_limits;   ///< some of its faces may reach the walk's limits
};

/// Scratch of a walk, kept from frame to frame.
struct WalkScratch {
    std::vector<WalkStep> steps;
    Table<std::uint32_t, Face> face_marks;  ///< the last frame in which an entered leaf lists the face
    std::uint32_t mark = 0;
    LeafSet entered{0};  ///< leaves: whatever shows a pixel is in one of them (FrontToBackWalk)
    World lowest_z{};    ///< of the boxes of entered leaves; World::lowest() after a second walk
};

/// A face returned by a walk. The members after `fragment` are set when the face owns pixels or pixels are seen through
/// it (frame/claims.h).
struct VisibleFace {
    FaceIndex face;
    const Fragment* fragment = nullptr;            ///< the part of a brush model's face; null: a face of the world
    std::uint32_t first_span = 0, span_count = 0;  ///< in Claims
    View nearest_z{}, farthest_z{};                ///< of the part in view
    ScreenRectangle bounds{};                      ///< holds its spans
    PlaneInverseZ inverse_z{};
};

/// A plane that limits a walk to one of its sides: that of a mirror, or of a cut through the level.
struct WalkLimit {
    LevelPlane plane;
    bool is_back = false;  ///< the walk is on the plane's back
    Vec3<World> offset;    ///< moves the plane with its model; if not zero, only faces are tested, not boxes
};

/// Returns the faces of a scene front to back, one at a time, until no pixel is free: the world's tree, near side
/// first (Fuchs, Kedem and Naylor 1980; Abrash, Black Book, ch. 62). Subtrees that cannot be seen from the eye's leaf,
/// that are outside the view, or whose rectangle on the screen has no free pixel are not entered.
///
/// There are two walks. The first returns the faces in the visible set that face the eye: for each node the parts of
/// brush models in its near leaves, then the faces on its plane. If pixels are still free after it, the second returns
/// all faces of the world, whichever way they face.
///
/// Why the second walk leaves no pixel free: the faces of a world are a closed surface (each edge is used once in each
/// direction: T-junctions are mended), and its winding number around an eye in the open is 1: along each ray, faces
/// clockwise on the screen count +1, counter-clockwise ones -1, and the sum is 1. Rounding moves a corner alike for all
/// its faces, and clipping leaves all faces of an edge the same part of it: the surface stays closed, and the sum
/// changes only where the surface passes through the eye, which place_eye() prevents. So a clockwise polygon covers
/// every pixel, however corners are rounded. But before rounding its face may face away or be outside the visible set,
/// so the first walk may miss it.
///
/// Where faces are missing (not `is_closed`), a second walk would show the backs of other rooms through the gaps, and
/// still leave pixels free. So there is none; frame/torn_pixels.h finds in the tree what is at the free pixels.
///
/// Everything that is seen in front of the faces is in leaves that the first walk enters: it enters each leaf along a
/// pixel's ray before it returns the face that is seen there, while the pixel is still free.
///
/// Where the void shows (ViewContext::shows_void) there is no second walk: neighbouring rays may begin outside, in
/// walls or in the open, and pixels that are free after the first walk show nothing.
class FrontToBackWalk {
  public:
    /// The arguments must outlive the walk. `models` is null if none is drawn.
    FrontToBackWalk(const Level& level, const ViewContext& view, const VisibleSet& visible, BrushModels* models,
                    const SpanBuffer& span_buffer, WalkScratch& scratch, std::span<const WalkLimit> limits = {},
                    bool is_closed = true);

    /// Sets `face` and `fragment` of the next face. False when no pixel is free or no face is left.
    bool next(VisibleFace& found);
    /// Whether the last face may reach the limits.
    bool may_reach_limits() const { return found_may_reach_limits_; }
    /// Whether the second walk has begun.
    bool is_second_walk() const { return is_second_walk_; }
    /// How many nodes were tested: those visible from the eye's leaf.
    std::int64_t nodes_tested() const { return nodes_tested_; }

  private:
    void start();
    void take_step();
    void push_back_facing(WalkStep step);
    void take_faces(const WalkStep& step, bool of_plane_front);
    /// Goes down the near sides to a leaf while something may be in view, and pushes the rest of each node as a step.
    void descend(NodeChild at, std::uint8_t sides, bool may_reach_limits);
    void enter_leaf(LeafIndex leaf, std::uint8_t sides);
    /// Whether something below may be returned.
    bool may_show(NodeChild at) const {
        if (is_second_walk_) return !at.is_leaf();
        return at.is_leaf() ? visible_.has_leaf(at.leaf()) : visible_.has_node(at.node());
    }
    bool is_beyond_limits(const LevelBox& box) const;
    bool is_well_within_limits(const LevelBox& box) const;
    /// Whether no pixel is free where a node's faces are. The first walk tests only nodes without leaves as children:
    /// near the leaves there are so few faces that the test costs more.
    bool is_hidden(const Node& node) const;
    /// False only if no pixel of the box is free.
    bool may_be_free(const LevelBox& box) const;
    bool is_wanted(FaceIndex face) const;

    const Level& level_;
    const ViewContext& view_;
    const VisibleSet& visible_;
    BrushModels* models_;
    const SpanBuffer& span_buffer_;
    WalkScratch& scratch_;
    std::span<const WalkLimit> limits_;
    BoxCuller culler_;
    bool is_closed_;  ///< the faces of the world are a closed surface
    bool is_second_walk_ = false;
    std::span<const Fragment* const> fragments_{};  ///< of the current leaf, not returned yet
    IndexRange<Face> faces_;                        ///< of the current node, not returned yet
    bool of_plane_front_ = false;                   ///< take those of the plane's front; false: of its back
    bool may_reach_limits_ = false, found_may_reach_limits_ = false;  ///< of the current node; of the last face
    std::int64_t nodes_tested_ = 0;
};

}  // namespace oblong
