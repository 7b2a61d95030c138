#include "engine/visibility/placed_box.h"

#include <algorithm>

#include "engine/level/side.h"

namespace oblong {

namespace {

constexpr std::size_t kMostLeaves = 256;

/// Which sides of a plane a box, 1 unit larger for rounding, reaches.
struct Sides {
    bool front, back;
};

Sides sides_of(const LevelPlane& plane, const LevelBox& box) {
    const auto half = [&](std::size_t axis, Unit normal) {
        const auto size = WorldWide::from_raw((std::int64_t{box.maxs[axis]} - box.mins[axis]) * 2048);
        return absolute(bounded_product(normal, size));
    };
    const PlaneDistance reach =
        half(0, plane.normal.x) + half(1, plane.normal.y) + half(2, plane.normal.z) + PlaneDistance::from_int(1);
    const PlaneDistance distance = plane_distance(plane, middle_of(box));
    return {distance > -reach, distance < reach};
}

}  // namespace

Vec3<World> middle_of(const LevelBox& box) {
    const auto middle = [&](std::size_t axis) { return World::from_raw((box.mins[axis] + box.maxs[axis]) * 2048); };
    return {middle(0), middle(1), middle(2)};
}

PlacedBox place_box(const Level& level, const LevelBox& box) {
    PlacedBox placed{box, {}, false};
    std::vector<NodeChild> pending{level.world().root};
    while (!pending.empty()) {
        const NodeChild at = pending.back();
        pending.pop_back();
        if (at.is_leaf()) {
            if (level.leaves[at.leaf()].contents != contents::kSolid) placed.leaves.push_back(at.leaf());
            if (placed.leaves.size() > kMostLeaves) return {box, {}, true};
            continue;
        }
        const Node& node = level.nodes[at.node()];
        const Sides sides = sides_of(level.planes[node.plane], box);
        if (sides.back) pending.push_back(node.children[1]);
        if (sides.front) pending.push_back(node.children[0]);
    }
    return placed;
}

bool may_be_seen(const PlacedBox& placed, const LeafSet& leaves, const BoxCuller& culler) {
    const auto is_visible = [&leaves](LeafIndex leaf) { return leaves.has(leaf); };
    if (!placed.has_many_leaves && std::none_of(placed.leaves.begin(), placed.leaves.end(), is_visible)) return false;
    return culler.sides_crossed(placed.box, kAllSides) != kOutside;
}

}  // namespace oblong
