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

std::uint8_t planes_crossed(const Frustum& frustum, const LevelBox& box, const Vec3<World>& eye, std::uint8_t planes) {
    if (planes == 0) return 0;
    const std::array at{convert<WorldWide>(eye.x), convert<WorldWide>(eye.y), convert<WorldWide>(eye.z)};
    for (unsigned side = 0; side < 4; ++side) {
        if (!(planes >> side & 1)) continue;
        const CullPlane& plane = frustum.cull_planes[side];
        CullDistance farthest, nearest;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const CullDistance low =
                bounded_product(plane.normal[axis], WorldWide::from_int(box.mins[axis]) - at[axis]);
            const CullDistance high =
                bounded_product(plane.normal[axis], WorldWide::from_int(box.maxs[axis]) - at[axis]);
            farthest += low > high ? low : high;
            nearest += low > high ? high : low;
        }
        note_range<"box's cull distance">(farthest);
        note_range<"box's cull distance">(nearest);
        if (farthest < plane.outside) return kOutside;
        if (nearest >= plane.inside) planes = static_cast<std::uint8_t>(planes & ~(1u << side));
    }
    return planes;
}

FrontToBackWalk::FrontToBackWalk(const Level& level, const ViewContext& view, const VisibleSet& visible,
                                 BrushModels* models, const SpanBuffer& span_buffer, WalkScratch& scratch,
                                 std::span<const WalkLimit> limits)
    : level_(level),
      view_(view),
      visible_(visible),
      models_(models),
      span_buffer_(span_buffer),
      scratch_(scratch),
      limits_(limits) {
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
        while (faces_.count > 0) {
            const FaceIndex face = faces_.take_first();
            if (is_wanted(face)) return VisibleFace{face, nullptr};
        }
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
    if (step.at.is_leaf()) return enter_leaf(step.at.leaf(), step.planes_to_test);
    if (!step.draws_faces) return enter_node(step.at.node(), step.planes_to_test);
    faces_ = level_.nodes[step.at.node()].faces;
    draws_front_ = step.draws_front;
}

void FrontToBackWalk::enter_leaf(LeafIndex index, std::uint8_t planes) {
    if (takes_all_faces_ || !visible_.has_leaf(index)) return;
    const Leaf& leaf = level_.leaves[index];
    if (planes_crossed(view_.frustum, leaf.box, view_.eye, planes) == kOutside) return;
    for (const FaceIndex face : level_.faces_at(leaf)) scratch_.face_marks[face] = scratch_.mark;
    if (models_ && models_->has_any_in(index)) fragments_ = models_->front_to_back_in(index, level_, view_.viewpoint);
}

void FrontToBackWalk::enter_node(NodeIndex index, std::uint8_t planes_to_test) {
    if (!takes_all_faces_ && !visible_.has_node(index)) return;
    ++nodes_entered_;
    const Node& node = level_.nodes[index];
    const std::uint8_t planes = planes_crossed(view_.frustum, node.box, view_.eye, planes_to_test);
    if (planes == kOutside || (!limits_.empty() && is_beyond_limits(node.box)) || is_hidden(node.box)) return;

    const PlaneDistance distance = plane_distance(level_.planes[node.plane], view_.viewpoint);
    const bool in_front = distance > PlaneDistance{}, has_faces = node.faces.count > 0;
    const bool is_thin = absolute(distance) < kBothSidesDistance;
    // Last in, first out: near side, faces toward the eye, far side; and those that face away but rounding may show,
    // whose leaves are on the far side.
    if (has_faces && is_thin && !takes_all_faces_)
        scratch_.steps.push_back({NodeChild(index), true, !in_front, planes});
    scratch_.steps.push_back({node.children[in_front], false, false, planes});
    if (has_faces && takes_all_faces_) scratch_.steps.push_back({NodeChild(index), true, !in_front, planes});
    if (has_faces) scratch_.steps.push_back({NodeChild(index), true, in_front, planes});
    scratch_.steps.push_back({node.children[!in_front], false, false, planes});
}

bool FrontToBackWalk::is_beyond_limits(const LevelBox& box) const {
    return std::any_of(limits_.begin(), limits_.end(), [&](const WalkLimit& limit) { return is_beyond(limit, box); });
}

bool FrontToBackWalk::is_hidden(const LevelBox& box) const {
    const std::optional<ScreenRectangle> rectangle = rectangle_of(box, view_);
    return rectangle && !span_buffer_.may_be_free(*rectangle);
}

}  // namespace oblong
