#include "engine/visibility/front_to_back.h"

#include <algorithm>

#include "engine/base/range_probe.h"
#include "engine/level/side.h"
#include "engine/visibility/box_rectangle.h"
#include "engine/visibility/viewpoint.h"

namespace oblong {

namespace {

/// If the eye is this near to a plane, faces on it that face away are returned too: rounded to the screen, such a face
/// may turn round and cover pixels that its neighbours, rounded too, leave free; most often it covers nothing. A face
/// of L units at depth z turns round where the eye's distance is d <= z^2 / (160 L) * (twice the rounding): 32 units
/// are enough for 16-unit faces 3,600 units away at 1/256 pixel. What coarser grids leave is for the second walk. In a
/// parallel view, from whose direction planes are 2^14 units times the cosine away, it is planes within 1/9 degree of
/// the rays: of faces up to 4 pixels long.
constexpr auto kBothSidesDistance = PlaneDistance::from_int(32);

/// Whether nothing of a box is on the limit's side: not its corner that is farthest there.
bool is_beyond(const WalkLimit& limit, const LevelBox& box) {
    if (limit.offset != Vec3<World>{}) return false;
    const std::array normal{limit.plane.normal.x, limit.plane.normal.y, limit.plane.normal.z};
    std::array<World, 3> corner{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool is_high = (normal[axis] > Unit{}) != limit.is_back;
        corner[axis] = World::from_int(is_high ? box.maxs[axis] : box.mins[axis]);
    }
    const PlaneDistance distance = plane_distance(limit.plane, Vec3<World>{corner[0], corner[1], corner[2]});
    return limit.is_back ? distance > PlaneDistance{} : distance < PlaneDistance{};
}

}  // namespace

FrontToBackWalk::FrontToBackWalk(const Level& level, const ViewContext& view, const VisibleSet& visible,
                                 BrushModels* models, const SpanBuffer& span_buffer, WalkScratch& scratch,
                                 std::span<const WalkLimit> limits)
    : level_(level),
      view_(view),
      visible_(visible),
      models_(models),
      span_buffer_(span_buffer),
      scratch_(scratch),
      limits_(limits),
      culler_(view.frustum, view.eye) {
    ++scratch_.mark;
    start();
}

void FrontToBackWalk::start() {
    scratch_.steps.assign(1, {level_.world().root, false, false, kAllSides});
}

std::optional<VisibleFace> FrontToBackWalk::next() {
    while (true) {
        if (!fragments_.empty()) {
            const Fragment* const fragment = fragments_.front();
            fragments_ = fragments_.subspan(1);
            return VisibleFace{fragment->face, fragment};
        }
        for (IndexRange<Face> rest = faces_; rest.count > 0;) {
            const FaceIndex face = rest.take_first();
            if (!is_wanted(face)) continue;
            faces_ = rest;
            return VisibleFace{face, nullptr};
        }
        faces_.count = 0;
        if (span_buffer_.is_full()) return std::nullopt;
        if (!scratch_.steps.empty()) {
            take_step();
        } else {
            if (takes_all_faces_ || view_.shows_void) return std::nullopt;
            takes_all_faces_ = true;
            start();
        }
    }
}

bool FrontToBackWalk::is_wanted(FaceIndex face) const {
    return (takes_all_faces_ || scratch_.face_marks[face] == scratch_.mark) &&
           level_.faces[face].is_back != draws_front_;
}

void FrontToBackWalk::take_step() {
    const WalkStep step = scratch_.steps.back();
    scratch_.steps.pop_back();
    if (!step.draws_faces) return descend(step.at, step.planes_to_test);
    faces_ = level_.nodes[step.at.node()].faces;
    draws_front_ = step.draws_front;
}

bool FrontToBackWalk::may_show(NodeChild at) const {
    if (takes_all_faces_) return !at.is_leaf();
    return at.is_leaf() ? visible_.has_leaf(at.leaf()) : visible_.has_node(at.node());
}

void FrontToBackWalk::descend(NodeChild at, std::uint8_t planes) {
    while (may_show(at)) {
        if (at.is_leaf()) return enter_leaf(at.leaf(), planes);
        ++nodes_entered_;
        const Node& node = level_.nodes[at.node()];
        planes = culler_.planes_crossed(node.box, planes);
        if (planes == kOutside || (!limits_.empty() && is_beyond_limits(node.box)) || is_hidden(node)) return;
        const PlaneDistance distance = plane_distance(level_.planes[node.plane], view_.viewpoint);
        const bool in_front = distance > PlaneDistance{};
        push_far_side(at.node(), node, distance, planes);
        at = node.children[!in_front];
    }
}

void FrontToBackWalk::push_far_side(NodeIndex index, const Node& node, PlaneDistance distance, std::uint8_t planes) {
    const bool in_front = distance > PlaneDistance{}, has_faces = node.faces.count > 0;
    const bool is_thin = absolute(distance) < kBothSidesDistance;
    const NodeChild far_side = node.children[in_front];
    // Last in, first out: faces toward the eye, far side; and those that face away but rounding may show, whose leaves
    // are on the far side.
    if (has_faces && is_thin && !takes_all_faces_)
        scratch_.steps.push_back({NodeChild(index), true, !in_front, planes});
    if (may_show(far_side)) scratch_.steps.push_back({far_side, false, false, planes});
    if (has_faces && takes_all_faces_) scratch_.steps.push_back({NodeChild(index), true, !in_front, planes});
    if (has_faces) scratch_.steps.push_back({NodeChild(index), true, in_front, planes});
}

void FrontToBackWalk::enter_leaf(LeafIndex index, std::uint8_t planes) {
    const Leaf& leaf = level_.leaves[index];
    if (culler_.planes_crossed(leaf.box, planes) == kOutside) return;
    for (const FaceIndex face : level_.faces_at(leaf)) scratch_.face_marks[face] = scratch_.mark;
    if (models_ && models_->has_any_in(index)) fragments_ = models_->front_to_back_in(index, level_, view_.viewpoint);
}

bool FrontToBackWalk::is_beyond_limits(const LevelBox& box) const {
    return std::any_of(limits_.begin(), limits_.end(), [&](const WalkLimit& limit) { return is_beyond(limit, box); });
}

bool FrontToBackWalk::is_hidden(const Node& node) const {
    const auto is_leaf = [](NodeChild child) { return child.is_leaf(); };
    if (!takes_all_faces_ && std::any_of(node.children.begin(), node.children.end(), is_leaf)) return false;
    const std::optional<ScreenRectangle> rectangle = rectangle_of(node.box, view_);
    return rectangle && !span_buffer_.may_be_free(*rectangle);
}

}  // namespace oblong
