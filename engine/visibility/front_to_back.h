#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/frustum.h"
#include "engine/level/level.h"
#include "engine/level/side.h"
#include "engine/visibility/visible_set.h"

namespace oblong {

/// What is left to do of a walk through the tree.
struct WalkStep {
    NodeChild at;
    bool draws_faces;             ///< false: enter the node; true: its near side is done, draw the faces on its plane
    bool draws_front;             ///< which of them: those that face the plane's front, or those that face its back
    std::uint8_t planes_to_test;  ///< sides of the view that the node's parent still crossed
};

/// Scratch of a walk, kept from frame to frame.
struct WalkScratch {
    std::vector<WalkStep> steps;
    Table<std::uint32_t, Face> face_marks;  ///< the frame in which a visited leaf last named the face
    std::uint32_t mark = 0;
};

/// Which of `planes` (a bit each: left, right, bottom, top) a box still crosses; 0xff if it lies outside of one.
std::uint8_t planes_crossed(const Frustum& frustum, const LevelBox& box, const Vec3<World>& eye, std::uint8_t planes);
inline constexpr std::uint8_t kAllSides = 15, kOutside = 0xff;

/// How near to a plane the eye may be so that faces which face away from it by a hair are drawn all the same: rounded
/// to the screen, such a face may turn round and show pixels that its neighbours, rounded too, leave. Drawn, it is what
/// closes the outline of what is seen; most often it covers nothing. A face of L units at depth z turns round where it
/// is d <= z^2 / (160 L) * (twice the rounding) before its plane: 32 units do for 16-unit faces 3,600 units away at
/// 1/256 pixel. What coarser grids leave is for walk_all_faces().
inline constexpr std::int64_t kBothSidesDistance_42 = std::int64_t{32} << 42;

/// Walks the world's tree front to back (Fuchs, Kedem and Naylor 1980; Abrash, Black Book, ch. 62). Calls on_leaf(leaf)
/// for every leaf that may be seen, and on_face(face) for the faces that border such leaves and face the eye. A face
/// comes after all that can hide it, and a leaf before the faces that close it. Subtrees whose box is_hidden(box) are
/// not entered; ends early when is_done() says so.
template <class OnLeaf, class OnFace, class IsHidden, class IsDone>
void walk_front_to_back(const Level& level, const Vec3<World>& eye, const Frustum& frustum, const VisibleSet& visible,
                        WalkScratch& scratch, OnLeaf on_leaf, OnFace on_face, IsHidden is_hidden, IsDone is_done) {
    const std::uint32_t mark = ++scratch.mark;
    scratch.steps.assign(1, {level.world().root, false, false, kAllSides});

    const auto draw_faces = [&](const Node& node, bool front) {
        for (const FaceIndex face : node.faces)
            if (scratch.face_marks[face] == mark && level.faces[face].is_back != front) on_face(face);
    };
    const auto enter_leaf = [&](LeafIndex index, std::uint8_t planes) {
        const Leaf& leaf = level.leaves[index];
        if (!visible.has_leaf(index) || planes_crossed(frustum, leaf.box, eye, planes) == kOutside) return;
        for (const FaceIndex face : level.faces_at(leaf)) scratch.face_marks[face] = mark;
        on_leaf(index);
    };

    while (!scratch.steps.empty() && !is_done()) {
        const WalkStep step = scratch.steps.back();
        scratch.steps.pop_back();
        if (step.at.is_leaf()) {
            enter_leaf(step.at.leaf(), step.planes_to_test);
            continue;
        }
        const Node& node = level.nodes[step.at.node()];
        if (step.draws_faces) {
            draw_faces(node, step.draws_front);
            continue;
        }
        if (!visible.has_node(step.at.node())) continue;
        const std::uint8_t planes = planes_crossed(frustum, node.box, eye, step.planes_to_test);
        if (planes == kOutside || is_hidden(node.box)) continue;
        const std::int64_t distance = plane_distance_42(level.planes[node.plane], eye);
        const bool in_front = distance > 0;
        // Last in, first out: near side, faces toward the eye, far side; and those that only rounding shows, whose
        // leaves are on the far side.
        const bool is_thin =
            node.faces.count > 0 && distance < kBothSidesDistance_42 && distance > -kBothSidesDistance_42;
        if (is_thin) scratch.steps.push_back({step.at, true, !in_front, planes});
        scratch.steps.push_back({node.children[in_front], false, false, planes});
        if (node.faces.count > 0) scratch.steps.push_back({step.at, true, in_front, planes});
        scratch.steps.push_back({node.children[!in_front], false, false, planes});
    }
}

/// Calls on_face(face) for all faces of the world, near ones first, whatever is seen from where and whichever way they
/// face: for the pixels that walk_front_to_back() leaves. Subtrees outside the view or whose box is_hidden(box) are not
/// entered; ends early when is_done() says so.
///
/// Why it leaves none. The faces of a world are a closed surface (each edge is walked once in each direction:
/// T-junctions are mended), and around an eye in its open side it is wound once: along each ray, faces that are
/// clockwise on the screen count +1, those that are counter-clockwise -1, and the sum is 1. Rounding moves corners, but
/// each for all its faces alike, and clipping leaves all faces of an edge the same part of it: the surface stays
/// closed, and the sum can only change where it passes through the eye, which place_eye() keeps clear of it. So every
/// pixel is covered by a clockwise outline, rounded by however much. But it may be that of a face which truly faces
/// away, or which is not in the visible set, as that is true of exact outlines only.
template <class OnFace, class IsHidden, class IsDone>
void walk_all_faces(const Level& level, const Vec3<World>& eye, const Frustum& frustum, WalkScratch& scratch,
                    OnFace on_face, IsHidden is_hidden, IsDone is_done) {
    scratch.steps.assign(1, {level.world().root, false, false, kAllSides});
    while (!scratch.steps.empty() && !is_done()) {
        const WalkStep step = scratch.steps.back();
        scratch.steps.pop_back();
        if (step.at.is_leaf()) continue;
        const Node& node = level.nodes[step.at.node()];
        if (step.draws_faces) {
            for (const bool front : {step.draws_front, !step.draws_front})
                for (const FaceIndex face : node.faces)
                    if (level.faces[face].is_back != front) on_face(face);
            continue;
        }
        const std::uint8_t planes = planes_crossed(frustum, node.box, eye, step.planes_to_test);
        if (planes == kOutside || is_hidden(node.box)) continue;
        const bool in_front = plane_distance_42(level.planes[node.plane], eye) > 0;
        scratch.steps.push_back({node.children[in_front], false, false, planes});
        scratch.steps.push_back({step.at, true, in_front, planes});
        scratch.steps.push_back({node.children[!in_front], false, false, planes});
    }
}

}  // namespace oblong
