#include "engine/visibility/front_to_back.h"

#include <algorithm>

#include "engine/base/range_probe.h"
#include "engine/level/side.h"
#include "engine/visibility/box_culler.h"
#include "engine/visibility/eye.h"

namespace oblong {

namespace {

/// If the eye is this near to a plane, faces on it that face away are returned too: rounded to the screen, such a face
/// may turn round and cover pixels that its rounded neighbours leave free, though mostly it covers nothing. A face of L
/// units at depth z turns round where the eye's distance is d <= z^2 / (160 L) * (twice the rounding): 32 units are
/// enough for 16-unit faces 3,600 units away at 1/256 pixel. Coarser grids leave the rest to the second walk. In a
/// parallel view plane_distance() is 2^14 units times a cosine, and 32 units are planes within 1/9 degree of the rays:
/// enough for faces up to 4 pixels long.
constexpr auto kBothSidesDistance = PlaneDistance::from_int(32);

/// How far a box's farthest or nearest corner is on the limit's side.
PlaneDistance corner_within(const WalkLimit& limit, const LevelBox& box, bool is_farthest) {
    const std::array normal{limit.plane.normal.x, limit.plane.normal.y, limit.plane.normal.z};
    std::array<World, 3> corner{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool is_high = (normal[axis] > Unit{}) != limit.is_back;
        corner[axis] = World::from_int(is_high == is_farthest ? box.maxs[axis] : box.mins[axis]);
    }
    return distance_before(limit.plane, limit.is_back, {corner[0], corner[1], corner[2]});
}

bool is_moved(const WalkLimit& limit) {
    return limit.offset != Vec3<World>{};
}

}  // namespace

FrontToBackWalk::FrontToBackWalk(const Level& level, const ViewContext& view, const VisibleSet& visible,
                                 BrushModels* models, const SpanBuffer& span_buffer, WalkScratch& scratch,
                                 std::span<const WalkLimit> limits, bool is_closed)
    : level_(level),
      view_(view),
      visible_(visible),
      models_(models),
      span_buffer_(span_buffer),
      scratch_(scratch),
      limits_(limits),
      culler_(view.frustum, view.eye),
      is_closed_(is_closed) {
    ++scratch_.mark;
    scratch_.entered.clear();
    scratch_.lowest_z = World::highest();
    start();
}

void FrontToBackWalk::start() {
    scratch_.steps.clear();
    descend(level_.world().root, kAllSides, !limits_.empty());
}

bool FrontToBackWalk::next(VisibleFace& found) {
    while (!span_buffer_.is_full()) {
        if (!fragments_.empty()) {
            found.fragment = fragments_.front();
            found.face = found.fragment->face;
            found_may_reach_limits_ = !limits_.empty();
            fragments_ = fragments_.subspan(1);
            return true;
        }
        for (IndexRange<Face> rest = faces_; rest.count > 0;) {
            const FaceIndex face = rest.take_first();
            if (!is_wanted(face)) continue;
            faces_ = rest;
            found.fragment = nullptr;
            found.face = face;
            found_may_reach_limits_ = may_reach_limits_;
            return true;
        }
        faces_.count = 0;
        if (!scratch_.steps.empty()) {
            take_step();
        } else {
            if (is_second_walk_ || view_.shows_void || !is_closed_) break;
            is_second_walk_ = true;
            scratch_.lowest_z = World::lowest();
            start();
        }
    }
    return false;
}

/// Without branches: every third face's would be mispredicted.
bool FrontToBackWalk::is_wanted(FaceIndex face) const {
    const bool is_marked = is_second_walk_ | (scratch_.face_marks[face] == scratch_.mark);
    return is_marked & (level_.faces[face].is_back != of_plane_front_);
}

void FrontToBackWalk::take_step() {
    using Next = WalkStep::Next;
    WalkStep& top = scratch_.steps.back();
    switch (top.next) {
        case Next::FrontFacing:
            top.next = Next::FarSide;
            take_faces(top, top.in_front);
            if (is_second_walk_) push_back_facing(top);
            return;
        case Next::FarSide: {
            const WalkStep step = top;
            top.next = Next::BackFacing;
            if (!step.takes_back_facing) scratch_.steps.pop_back();
            return descend(level_.nodes[step.node].children[step.in_front], step.sides, step.may_reach_limits);
        }
        case Next::BackFacing:
            take_faces(top, !top.in_front);
            return scratch_.steps.pop_back();
    }
}

/// Leaves do not matter to the second walk: after the faces on one side of a plane it takes those on the other. Not
/// inlined, as to append takes registers that the first walk would save and restore at each step.
[[gnu::noinline]] void FrontToBackWalk::push_back_facing(WalkStep step) {
    step.next = WalkStep::Next::BackFacing;
    scratch_.steps.push_back(step);
}

void FrontToBackWalk::take_faces(const WalkStep& step, bool of_plane_front) {
    faces_ = level_.nodes[step.node].faces;
    of_plane_front_ = of_plane_front;
    may_reach_limits_ = step.may_reach_limits;
}

void FrontToBackWalk::descend(NodeChild at, std::uint8_t sides, bool may_reach_limits) {
    while (may_show(at)) {
        if (at.is_leaf()) return enter_leaf(at.leaf(), sides);
        ++nodes_tested_;
        const Node& node = level_.nodes[at.node()];
        sides = culler_.sides_crossed(node.box, sides);
        if (sides == kOutside || (may_reach_limits && is_beyond_limits(node.box)) || is_hidden(node)) return;
        may_reach_limits = may_reach_limits && !is_well_within_limits(node.box);
        const PlaneDistance distance = plane_distance(level_.planes[node.plane], view_.viewpoint);
        const bool in_front = distance > PlaneDistance{}, has_faces = node.faces.count > 0;
        // They come after the far side, as its leaves mark them.
        const bool takes_back_facing = has_faces && absolute(distance) < kBothSidesDistance && !is_second_walk_;
        // Named, since GCC does not inline the appending of a temporary.
        const WalkStep step{at.node(), has_faces ? WalkStep::Next::FrontFacing : WalkStep::Next::FarSide,
                            in_front,  takes_back_facing,
                            sides,     may_reach_limits};
        scratch_.steps.push_back(step);
        at = node.children[!in_front];
    }
}

void FrontToBackWalk::enter_leaf(LeafIndex index, std::uint8_t sides) {
    const Leaf& leaf = level_.leaves[index];
    scratch_.entered.add(index);
    scratch_.lowest_z = std::min(scratch_.lowest_z, World::from_int(leaf.box.mins[2]));
    if (culler_.sides_crossed(leaf.box, sides) == kOutside) return;
    for (const FaceIndex face : level_.faces_at(leaf)) scratch_.face_marks[face] = scratch_.mark;
    if (!models_ || !models_->has_any_in(index)) return;
    const std::function<bool(const LevelBox&)> is_free = [this](const LevelBox& box) { return may_be_free(box); };
    fragments_ = models_->front_to_back_in(index, {level_, view_.viewpoint, culler_, is_free});
}

bool FrontToBackWalk::is_beyond_limits(const LevelBox& box) const {
    return std::any_of(limits_.begin(), limits_.end(), [&](const WalkLimit& limit) {
        return !is_moved(limit) && corner_within(limit, box, true) < PlaneDistance{};
    });
}

/// Within by at least one unit: nearer corners may count as on a limit's plane (polygon_side).
bool FrontToBackWalk::is_well_within_limits(const LevelBox& box) const {
    return std::none_of(limits_.begin(), limits_.end(), [&](const WalkLimit& limit) {
        return is_moved(limit) || corner_within(limit, box, false) < PlaneDistance::from_int(1);
    });
}

bool FrontToBackWalk::is_hidden(const Node& node) const {
    if (!is_second_walk_ && (node.children[0].is_leaf() || node.children[1].is_leaf())) return false;
    return !may_be_free(node.box);
}

bool FrontToBackWalk::may_be_free(const LevelBox& box) const {
    return span_buffer_.has_free(rectangle_of(box, view_));
}

}  // namespace oblong
