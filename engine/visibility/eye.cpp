#include "engine/visibility/eye.h"

#include <algorithm>
#include <cstdlib>

#include "engine/level/side.h"

namespace oblong {

namespace {

constexpr auto kClearance = PlaneDistance::from_raw(std::int64_t{2} << 30);
constexpr std::int32_t kMostRounds = 16;
/// At a corner three planes meet, and perhaps a fourth: for each, either side may be the open one.
constexpr unsigned kMostFlips = 4;

/// The eye moved off a plane along the coordinate in which the normal is largest, where that changes the distance most.
Vec3<World> moved_off(Vec3<World> eye, const LevelPlane& plane, int side, std::int32_t scale) {
    const Unit x = absolute(plane.normal.x), y = absolute(plane.normal.y), z = absolute(plane.normal.z);
    const bool is_x = x >= y && x >= z, is_y = !is_x && y >= z;
    const Unit component = is_x ? plane.normal.x : is_y ? plane.normal.y : plane.normal.z;
    // 2 steps of distance are at most 2 sqrt(3) steps along the largest component.
    const auto step = World::from_raw((plane.axis < 3 ? 2 : 4) * scale);
    (is_x ? eye.x : is_y ? eye.y : eye.z) += (component > Unit{}) == (side > 0) ? step : -step;
    return eye;
}

bool is_too_near(const LevelPlane& plane, Vec3<World> eye, int side) {
    const PlaneDistance distance = plane_distance(plane, eye);
    return (side > 0 ? distance : -distance) < kClearance;
}

bool is_solid(const Level& level, LeafIndex leaf) {
    return level.leaves[leaf].contents == contents::kSolid;
}

/// One attempt at placing an eye: whether it is clear of all the planes that bound its leaf.
struct Try {
    PlacedEye placed;
    bool is_clear = false;

    bool is_clear_and_open(const Level& level) const { return is_clear && !is_solid(level, placed.leaf); }
};

/// Goes down to the eye's leaf, at the planes that it is too near to on the other side where `other_sides` has a bit
/// for them (the first such plane's is bit 0), and moves it clear of them all: they are the planes that bound the leaf.
/// In a sharp corner clearing one plane comes nearer to another, so that it takes some rounds, of growing steps.
Try move_clear(const Level& level, Vec3<World> eye, unsigned other_sides) {
    bool is_clear = false;
    for (std::int32_t round = 0; round < kMostRounds; ++round) {
        unsigned near_count = 0;
        NodeChild at = level.world().root;
        Vec3<World> moved = eye;
        while (!at.is_leaf()) {
            const Node& node = level.nodes[at.node()];
            const LevelPlane& plane = level.planes[node.plane];
            int side = plane_side(plane, eye) > 0 ? 1 : -1;
            if (is_too_near(plane, eye, side)) {
                ++near_count;
                if (round == 0 && (other_sides >> (near_count - 1) & 1) != 0) side = -side;
                if (is_too_near(plane, moved, side)) moved = moved_off(moved, plane, side, 1 + round / 2);
            }
            at = node.children[side > 0 ? 0 : 1];
        }
        is_clear = near_count == 0;
        if (moved == eye) break;
        eye = moved;
    }
    return {{eye, find_leaf(level, level.world(), eye)}, is_clear};
}

bool is_clear(const Level& level, Vec3<World> eye) {
    NodeChild at = level.world().root;
    while (!at.is_leaf()) {
        const Node& node = level.nodes[at.node()];
        const LevelPlane& plane = level.planes[node.plane];
        const int side = plane_side(plane, eye) > 0 ? 1 : -1;
        if (is_too_near(plane, eye, side)) return false;
        at = node.children[side > 0 ? 0 : 1];
    }
    return true;
}

/// The first clear and open place on cubes of growing size around the eye, up to 1/32 unit away: for the edges of
/// wedges so sharp that the way off one of their planes leads through the other.
Try search_around(const Level& level, const Vec3<World>& eye) {
    constexpr std::int32_t kParts = 16, kLargestStep = 8;
    const auto try_at = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
        const Vec3<World> place = eye + Vec3<World>{World::from_raw(x), World::from_raw(y), World::from_raw(z)};
        return Try{{place, find_leaf(level, level.world(), place)}, is_clear(level, place)};
    };
    for (std::int32_t step = 1; step <= kLargestStep; step *= 2)
        for (std::int32_t x = -kParts; x <= kParts; ++x)
            for (std::int32_t y = -kParts; y <= kParts; ++y)
                for (std::int32_t z = -kParts; z <= kParts; ++z) {
                    if (std::max({std::abs(x), std::abs(y), std::abs(z)}) < kParts) continue;
                    const Try found = try_at(x * step, y * step, z * step);
                    if (found.is_clear_and_open(level)) return found;
                }
    return {};
}

}  // namespace

PlacedEye place_eye(const Level& level, Vec3<World> eye) {
    const Try first = move_clear(level, eye, 0);
    const bool was_clear = first.is_clear && first.placed.position == eye;  // in the open or deep in a wall
    if (was_clear || first.is_clear_and_open(level)) return first.placed;
    for (unsigned other_sides = 1; other_sides < 1u << kMostFlips; ++other_sides) {
        const Try other = move_clear(level, eye, other_sides);
        if (other.is_clear_and_open(level)) return other.placed;
    }
    const Try nearby = search_around(level, eye);
    return nearby.is_clear ? nearby.placed : first.placed;
}

}  // namespace oblong
