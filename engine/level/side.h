#pragma once

#include <optional>

#include "engine/base/range_probe.h"
#include "engine/fixed/arithmetic.h"
#include "engine/level/level.h"

namespace oblong {

/// normal . p - distance, without the rests of LevelPlane: within 2^-10 units of the exact value (2^-17 for points
/// within 4,096 units of the origin). For any p and any plane that the level reader accepts.
inline PlaneDistance plane_distance(const LevelPlane& plane, const Vec3<World>& p) {
    // Below 0.9 * 2^62 (a point of length 0.87 * 2^32 times a normal of 1.03 * 2^30) plus 2^62.
    const PlaneDistance distance = dot(p, plane.normal) - plane.distance;
    note_range<"plane distance">(distance);
    return distance;
}

/// How far a point is in front of a face, or of one side of its plane.
inline PlaneDistance distance_before(const LevelPlane& plane, bool is_back, const Vec3<World>& p) {
    const PlaneDistance distance = plane_distance(plane, p);
    return is_back ? -distance : distance;
}

/// s . p with each product rounded: for some p an exact sum would overflow.
inline Texel texel_along(const Vec3<TexelAxis>& axis, const Vec3<World>& p) {
    return product<Texel>(axis.x, p.x) + product<Texel>(axis.y, p.y) + product<Texel>(axis.z, p.z);
}

/// The exact side of a point, from all bits of LevelPlane: +1 in front (normal . p > distance), 0 on the plane, -1
/// behind.
int plane_side(const LevelPlane& plane, Vec3<World> p);

/// Whether a point is behind a face of the plane, or in it.
bool is_behind(const LevelPlane& plane, bool is_back, const Vec3<World>& p);

/// The leaf of a model that holds a point. A point on a plane belongs to its back. `p` is in the model's coordinates.
LeafIndex find_leaf(const Level& level, const SubModel& model, Vec3<World> p);

/// Calls visit(leaf, entered, place) for each leaf along a line, in order, until one returns true; returns whether one
/// did. `place` is where the line enters the leaf, `entered` the node on whose plane that is, none for the first leaf.
/// The ends are at most 2^20 units apart, so that the difference of two distances fits.
template <class Visit>
bool walk_line(const Level& level, NodeChild at, Vec3<World> from, const Vec3<World>& to,
               std::optional<NodeIndex> entered, const Visit& visit) {
    while (!at.is_leaf()) {
        const NodeIndex index = at.node();
        const Node& node = level.nodes[index];
        const PlaneDistance first = plane_distance(level.planes[node.plane], from),
                            last = plane_distance(level.planes[node.plane], to);
        const bool starts_back = first < PlaneDistance{}, ends_back = last < PlaneDistance{};
        at = node.children[ends_back];
        if (starts_back == ends_back) continue;
        const Vec3<World> middle = between(from, to, first, first - last);
        if (walk_line(level, node.children[starts_back], from, middle, entered, visit)) return true;
        from = middle;
        entered = index;
    }
    return visit(at.leaf(), entered, from);
}

}  // namespace oblong
