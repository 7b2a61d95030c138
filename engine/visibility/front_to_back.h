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

/// What is left to do at a node when its near side is done, one thing after the other.
struct WalkStep {
    enum class Next : std::uint8_t { NearFaces, FarSide, FarFaces };

    NodeIndex node;
    Next next;            ///< the faces on its plane that face the eye, the far side, the faces that face away
    bool in_front;        ///< which side the eye is on
    bool has_far_faces;   ///< those that face away are to come, too
    std::uint8_t planes;  ///< sides of the view that the node crosses
    bool nears_limits;    ///< its faces may not all be well within the walk's limits
};

/// Scratch of a walk, kept from frame to frame.
struct WalkScratch {
    std::vector<WalkStep> steps;
    Table<std::uint32_t, Face> face_marks;  ///< the frame in which a visited leaf last named it
    std::uint32_t mark = 0;
    LeafSet entered{0};  ///< leaves: what shows no pixel of the view's is in none of them (FrontToBackWalk)
    World lowest{};      ///< z of their boxes; of all faces that are found by a second walk, too
};

/// A face that a walk has come to. The rest is known where it owns pixels, or sees through to those behind it
/// (frame/claims.h).
struct VisibleFace {
    FaceIndex face;
    const Fragment* fragment = nullptr;  ///< the part of a brush model's face that it is; null: a face of the world
    std::uint32_t first_span = 0, span_count = 0;  ///< in Claims
    View nearest_z{}, farthest_z{};                ///< of the face's part in view
    ScreenRectangle bounds{};                      ///< holds its spans; empty: not known
    PlaneInverseZ inverse_z{};
};

/// One side of a plane, beyond which a walk does not go: what a mirror shows is before it, and what a cut keeps.
struct WalkLimit {
    LevelPlane plane;
    bool is_back = false;  ///< the plane's back is the side that is walked
    Vec3<World> offset;    ///< of the plane, moved with its model: then no more than faces are compared with it
};

/// Returns the faces of a scene front to back, one at a time, until no pixel is free: the world's tree, near side
/// first (Fuchs, Kedem and Naylor 1980; Abrash, Black Book, ch. 62). Subtrees that cannot be seen from the eye's leaf,
/// that are outside the view, or whose rectangle on the screen has no free pixel are not entered.
///
/// Two walks. The first returns faces in the visible set that face the eye: of each node the parts of brush
/// models in its near leaves, then the faces on its plane. If pixels are still free after it, the second returns all
/// faces of the world, whichever way they face.
///
/// Why the second leaves none. The faces of a world are a closed surface (each edge is used once in each direction:
/// T-junctions are mended), and its winding number around an eye in the open is 1: along each ray, faces that are
/// clockwise on the screen count +1, those that are counter-clockwise -1, and the sum is 1. Rounding moves corners, but
/// each for all its faces alike, and clipping leaves all faces of an edge the same part of it: the surface stays
/// closed, and the sum can only change where it passes through the eye, which place_eye() keeps clear of it. So every
/// pixel is covered by a clockwise polygon, however it is rounded. But that may belong to a face which exactly computed
/// faces away, or which is not in the visible set: those tests are right for unrounded polygons only.
///
/// Where faces are missing (not `is_closed`), the second walk would show the backs of other rooms through the gaps, and
/// still leave some pixels free: there is none, and what stands at the free pixels is asked of the tree
/// (frame/torn_pixels.h).
///
/// What is seen before its faces is in leaves that the first walk enters: on the way along a ray to the face that is
/// seen there, each leaf comes before that face, while the pixel is still free.
///
/// Where the void shows (ViewContext::shows_void) there is no second walk: rays begin outside, inside walls and in the
/// open side by side, and what is free after the first shows nothing.
class FrontToBackWalk {
  public:
    /// The arguments must outlive it. `models` is null where none is drawn.
    FrontToBackWalk(const Level& level, const ViewContext& view, const VisibleSet& visible, BrushModels* models,
                    const SpanBuffer& span_buffer, WalkScratch& scratch, std::span<const WalkLimit> limits = {},
                    bool is_closed = true);

    /// Sets `found` to the next face: which it is, and nothing else. False when no pixel is free, or no face is left.
    bool next(VisibleFace& found);
    /// Whether what it found last may not be well within its limits.
    bool nears_limits() const { return found_nears_limits_; }
    /// Whether the second walk has begun.
    bool takes_all_faces() const { return takes_all_faces_; }
    /// How many nodes it has entered: those in sight of the eye's leaf.
    std::int64_t nodes_entered() const { return nodes_entered_; }

  private:
    void start();
    void take_step();
    void take_faces(const WalkStep& step, bool draws_front);
    /// Goes down the near sides to a leaf, as far as something may be in view, and leaves the rest of each node for
    /// later steps.
    void descend(NodeChild at, std::uint8_t planes_to_test, bool nears_limits);
    void enter_leaf(LeafIndex leaf, std::uint8_t planes);
    /// Whether anything there is to be returned.
    bool may_show(NodeChild at) const {
        if (takes_all_faces_) return !at.is_leaf();
        return at.is_leaf() ? visible_.has_leaf(at.leaf()) : visible_.has_node(at.node());
    }
    bool is_beyond_limits(const LevelBox& box) const;
    bool is_well_within_limits(const LevelBox& box) const;
    /// Whether no pixel is free where a node's faces are. Is asked in the first walk of nodes between other nodes only:
    /// near the leaves there are few faces, and the test costs more than they do.
    bool is_hidden(const Node& node) const;
    /// False only if no pixel is free where a box is.
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
    bool is_closed_;                                ///< the faces of the world are a closed surface
    bool takes_all_faces_ = false;                  ///< the second walk
    std::span<const Fragment* const> fragments_{};  ///< of the current leaf, still to be returned
    IndexRange<Face> faces_;                        ///< of the current node, still to be returned
    bool draws_front_ = false;
    bool nears_limits_ = false, found_nears_limits_ = false;  ///< the faces of the current node; what was found last
    std::int64_t nodes_entered_ = 0;
};

}  // namespace oblong
