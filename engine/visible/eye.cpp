#include "engine/visible/eye.h"

#include <array>

#include "engine/level/side.h"

namespace oblong {

namespace {

constexpr std::int64_t kClearance_42 = std::int64_t{2} << 30;
constexpr std::int32_t kMostRounds = 16;
/// At a corner three planes meet, and an edge of a fourth: each may have its open side before or behind.
constexpr unsigned kMostFlips = 4;

/// The component of the normal that is largest: moving along it changes the distance most.
Vec3<World> moved_off(Vec3<World> eye, const LevelPlane& plane, int side, std::int32_t scale) {
    const std::array<std::int64_t, 3> normal{plane.normal.x.raw, plane.normal.y.raw, plane.normal.z.raw};
    std::array<std::int32_t*, 3> coordinate{&eye.x.raw, &eye.y.raw, &eye.z.raw};
    std::size_t largest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
        if (normal[axis] * normal[axis] > normal[largest] * normal[largest]) largest = axis;
    // 2 steps of distance are at most 2 sqrt(3) steps along the largest component.
    const std::int32_t steps = (plane.axis < 3 ? 2 : 4) * scale;
    *coordinate[largest] += (normal[largest] > 0) == (side > 0) ? steps : -steps;
    return eye;
}

bool is_too_near(const LevelPlane& plane, Vec3<World> eye, int side) {
    return plane_distance_42(plane, eye) * side < kClearance_42;
}

bool is_solid(const Level& level, std::int32_t leaf) {
    return level.leaves[static_cast<std::size_t>(leaf)].contents == contents::kSolid;
}

/// Goes down to the eye's leaf, at the planes that it is too near to on the other side where `other_sides` has a bit
/// for them (the first such plane's is bit 0), and moves it clear of them all: they are the planes that bound the leaf.
/// In a sharp corner clearing one plane comes nearer to another, so that it takes some rounds, of growing steps.
PlacedEye move_clear(const Level& level, Vec3<World> eye, unsigned other_sides) {
    for (std::int32_t round = 0; round < kMostRounds; ++round) {
        unsigned near_count = 0;
        std::int32_t node = level.models[0].head_nodes[0];
        Vec3<World> moved = eye;
        while (node >= 0) {
            const Node& at = level.nodes[static_cast<std::size_t>(node)];
            const LevelPlane& plane = level.planes[static_cast<std::size_t>(at.plane)];
            int side = plane_side(plane, eye) > 0 ? 1 : -1;
            if (is_too_near(plane, eye, side)) {
                if (round == 0 && (other_sides >> near_count++ & 1) != 0) side = -side;
                if (is_too_near(plane, moved, side)) moved = moved_off(moved, plane, side, 1 + round / 2);
            }
            node = at.children[side > 0 ? 0 : 1];
        }
        if (moved == eye) break;
        eye = moved;
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
