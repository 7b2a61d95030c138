#include "engine/visible/eye.h"

#include <array>
#include <optional>

#include "engine/level/side.h"

namespace oblong {

namespace {

constexpr std::int64_t kClearance_42 = std::int64_t{2} << 30;
constexpr unsigned kMostMoves = 8;
/// At a corner three planes meet, and an edge of a fourth: each may have its open side before or behind.
constexpr unsigned kMostFlips = 4;

/// The component of the normal that is largest: moving along it changes the distance most.
Vec3<World> moved_off(Vec3<World> eye, const LevelPlane& plane, int side) {
    const std::array<std::int64_t, 3> normal{plane.normal.x.raw, plane.normal.y.raw, plane.normal.z.raw};
    std::array<std::int32_t*, 3> coordinate{&eye.x.raw, &eye.y.raw, &eye.z.raw};
    std::size_t largest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
        if (normal[axis] * normal[axis] > normal[largest] * normal[largest]) largest = axis;
    // 2 steps of distance are at most 2 sqrt(3) steps along the largest component.
    const std::int32_t steps = plane.axis < 3 ? 2 : 4;
    *coordinate[largest] += (normal[largest] > 0) == (side > 0) ? steps : -steps;
    return eye;
}

/// The first plane on the way down to the eye's leaf that the eye is too near to.
std::optional<std::int32_t> plane_too_near(const Level& level, Vec3<World> eye) {
    std::int32_t node = level.models[0].head_nodes[0];
    while (node >= 0) {
        const Node& at = level.nodes[static_cast<std::size_t>(node)];
        const LevelPlane& plane = level.planes[static_cast<std::size_t>(at.plane)];
        const std::int64_t distance = plane_distance_42(plane, eye);
        if (distance < kClearance_42 && distance > -kClearance_42) return at.plane;
        node = at.children[plane_side(plane, eye) > 0 ? 0 : 1];
    }
    return std::nullopt;
}

bool is_solid(const Level& level, std::int32_t leaf) {
    return level.leaves[static_cast<std::size_t>(leaf)].contents == contents::kSolid;
}

/// Moves the eye clear of plane after plane: of the i-th to the side that it is on, or to the other if bit i of
/// `other_sides` says so.
PlacedEye move_clear(const Level& level, Vec3<World> eye, unsigned other_sides) {
    for (unsigned move = 0; move < kMostMoves; ++move) {
        const std::optional<std::int32_t> near = plane_too_near(level, eye);
        if (!near) break;
        const LevelPlane& plane = level.planes[static_cast<std::size_t>(*near)];
        const bool in_front = (plane_side(plane, eye) > 0) != ((other_sides >> move & 1) != 0);
        eye = moved_off(eye, plane, in_front ? 1 : -1);
    }
    return {eye, find_leaf(level, level.models[0], eye)};
}

}  // namespace

PlacedEye place_eye(const Level& level, Vec3<World> eye) {
    const PlacedEye placed = move_clear(level, eye, 0);
    if (placed.position == eye || !is_solid(level, placed.leaf)) return placed;
    for (unsigned other_sides = 1; other_sides < 1u << kMostFlips; ++other_sides) {
        const PlacedEye other = move_clear(level, eye, other_sides);
        if (!is_solid(level, other.leaf)) return other;
    }
    return placed;
}

}  // namespace oblong
