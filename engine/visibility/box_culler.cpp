#include "engine/visibility/box_culler.h"

#include <algorithm>

#include "engine/level/side.h"

namespace oblong {

BoxCuller::BoxCuller(const Frustum& frustum, const Vec3<World>& eye) {
    for (std::size_t side = 0; side < sides_.size(); ++side) {
        const CullPlane& plane = frustum.cull_planes[side];
        const CullDistance of_eye = dot(plane.normal, eye);
        const auto n = convert<Component>(plane.normal);
        const auto limit = [of_eye](CullDistance distance) {
            return -convert<CullPlane::Component>(-(distance + of_eye) * 2, Rounding::Floor);
        };
        sides_[side] = {n, {absolute(n.x), absolute(n.y), absolute(n.z)}, limit(plane.outside), limit(plane.inside)};
    }
}

namespace {

using HalfUnits = Fixed<std::int32_t, 1>;

/// A box's extent along one axis of viewspace.
struct Extent {
    View least, greatest;
};

Extent extent_along(const Vec3<Unit>& axis, View middle, const Vec3<HalfUnits>& half) {
    const auto part = [](Unit component, HalfUnits size) { return widening_product(absolute(component), size); };
    const auto sum = part(axis.x, half.x) + part(axis.y, half.y) + part(axis.z, half.z);
    const View reach = convert<View>(sum, Rounding::Floor) + View::from_raw(2);
    return {middle - reach, middle + reach};
}

/// Nearer than this, rounding moves a point by more than a pixel.
constexpr View kExactFrom = View::from_int(4);

/// The pixels of an extent along one axis of the screen. An end is farthest from the centre where z is least, nearest
/// where z is greatest.
PixelRange project_extent(const ProjectionAxis& axis, const Extent& across, const Extent& z, std::int32_t size_px) {
    const bool is_near = z.least < kExactFrom;
    // Positions are rounded by half a unit at most (Accuracy::view_bits).
    const View margin = is_near ? View::from_int(1) : View{};
    const auto project_end = [&](View end, bool outward) {
        if (outward && is_near) return end < View{} ? std::int64_t{0} : std::int64_t{size_px};
        return floor_of(axis.centre + project_axis(axis, end, outward ? z.least : z.greatest));
    };
    const auto within = [&](std::int64_t pixel) {
        return static_cast<std::int32_t>(std::clamp<std::int64_t>(pixel, 0, size_px));
    };
    const View low = across.least - margin, high = across.greatest + margin;
    return {within(project_end(low, low < View{}) - 1), within(project_end(high, high > View{}) + 2)};
}

}  // namespace

ScreenRectangle rectangle_of(const LevelBox& box, const ViewContext& view) {
    // Half of the sum and half of the difference: half a unit is 2,048 steps of World. Half the difference is one unit
    // larger, as files round boxes.
    const auto middle = [](std::int32_t low, std::int32_t high) { return World::from_raw((low + high) * 2048); };
    const auto half = [](std::int32_t low, std::int32_t high) { return HalfUnits::from_raw(high - low + 2); };
    const Vec3<HalfUnits> sizes{half(box.mins[0], box.maxs[0]), half(box.mins[1], box.maxs[1]),
                                half(box.mins[2], box.maxs[2])};
    const Vec3<View> centre = to_unadjusted_view(
        {middle(box.mins[0], box.maxs[0]), middle(box.mins[1], box.maxs[1]), middle(box.mins[2], box.maxs[2])}, view);

    const Extent z = extent_along(view.axes.forward, centre.z + view.parallel_depth, sizes);
    if (z.greatest < kExactFrom) return {0, view.projection.width_px, 0, view.projection.height_px};
    const Extent x = extent_along(view.axes.right, centre.x, sizes);
    const Extent y = extent_along(view.axes.up, -centre.y, sizes);
    const PixelRange columns = project_extent(view.projection.x, x, z, view.projection.width_px);
    const PixelRange rows = project_extent(view.projection.y, y, z, view.projection.height_px);
    return {columns.first, columns.end, rows.first, rows.end};
}

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
    if (culler.sides_crossed(placed.box, kAllSides) == kOutside) return false;
    const auto is_visible = [&leaves](LeafIndex leaf) { return leaves.has(leaf); };
    return placed.has_many_leaves || std::any_of(placed.leaves.begin(), placed.leaves.end(), is_visible);
}

}  // namespace oblong
