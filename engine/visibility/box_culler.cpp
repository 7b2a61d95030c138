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

/// A box's middle in viewspace, and half its sizes: one unit larger, as files round boxes.
struct Middle {
    Vec3<View> place;
    Vec3<HalfUnits> half;

    Middle(const LevelBox& box, const ViewContext& view) : place(to_unadjusted_view(middle_of(box), view)) {
        const auto size = [&box](std::size_t axis) { return HalfUnits::from_raw(box.maxs[axis] - box.mins[axis] + 2); };
        half = {size(0), size(1), size(2)};
        place.z += view.parallel_depth;
    }
};

}  // namespace

ScreenRectangle rectangle_of(const LevelBox& box, const ViewContext& view) {
    const auto [centre, sizes] = Middle(box, view);
    const Extent z = extent_along(view.axes.forward, centre.z, sizes);
    if (z.greatest < kExactFrom) return {0, view.projection.width_px, 0, view.projection.height_px};
    const Extent x = extent_along(view.axes.right, centre.x, sizes);
    const Extent y = extent_along(view.axes.up, -centre.y, sizes);
    const PixelRange columns = project_extent(view.projection.x, x, z, view.projection.width_px);
    const PixelRange rows = project_extent(view.projection.y, y, z, view.projection.height_px);
    return {columns.first, columns.end, rows.first, rows.end};
}

ScreenOutline outline_of(const LevelBox& box, const ViewContext& view) {
    const auto [middle, half] = Middle(box, view);
    const auto arm = [&axes = view.axes](Unit Vec3<Unit>::*axis, HalfUnits size) {
        const auto along = [&](const Vec3<Unit>& way) { return convert<View>(widening_product(way.*axis, size)); };
        return Vec3<View>{along(axes.right), along(axes.up), along(axes.forward)};
    };
    return outline_of({middle, {arm(&Vec3<Unit>::x, half.x), arm(&Vec3<Unit>::y, half.y), arm(&Vec3<Unit>::z, half.z)}},
                      view.projection);
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

InverseDepth nearest_inverse_depth_of(const LevelBox& box, const ViewContext& view) {
    const auto nearest = [&box](std::size_t axis, Unit forward) {
        return World::from_int(forward > Unit{} ? box.mins[axis] : box.maxs[axis]);
    };
    const Vec3<Unit>& forward = view.axes.forward;
    const View z =
        to_view({nearest(0, forward.x), nearest(1, forward.y), nearest(2, forward.z)}, view.eye, view.axes).z;
    return to_inverse_depth(reciprocal<InverseZ>(std::max(z, View::from_int(1))));
}

InverseDepth nearest_inverse_depth_of(const ViewBox& box) {
    return to_inverse_depth(reciprocal<InverseZ>(std::max(box.nearest_z(), View::from_int(1))));
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

bool reaches(const PlacedBox& placed, const LeafSet& leaves) {
    const auto is_visible = [&leaves](LeafIndex leaf) { return leaves.has(leaf); };
    return placed.has_many_leaves || std::any_of(placed.leaves.begin(), placed.leaves.end(), is_visible);
}

bool may_be_seen(const PlacedBox& placed, const LeafSet& leaves, const BoxCuller& culler) {
    return culler.sides_crossed(placed.box, kAllSides) != kOutside && reaches(placed, leaves);
}

}  // namespace oblong
