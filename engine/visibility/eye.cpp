#include "engine/visibility/eye.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <vector>

#include "engine/base/table.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

constexpr auto kClearance = PlaneDistance::from_raw(std::int64_t{2} << 30);
constexpr std::int32_t kMostRounds = 16;
/// At a corner three planes meet, perhaps four; either side of each may be the open one.
constexpr unsigned kMostFlips = 4;

/// Moves the eye off a plane along the largest component of the normal, which changes the distance most.
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

/// Goes down to the eye's leaf and moves the eye clear of all planes on the way that are too near. At the n-th such
/// plane (from 0), bit n of `other_sides` means: take the other side. In a sharp corner, clearing one plane comes
/// nearer to another, so it takes several rounds with growing steps.
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

/// The part of the world's tree inside a cube around an eye: a search of thousands of places tests its few planes, not
/// the whole tree.
class NearTree {
  public:
    NearTree(const Level& level, const Vec3<World>& middle, World half_size)
        : root_(add(level, level.world().root, middle, half_size)) {}

    bool has_open_leaf() const { return root_ != Child::Solid; }

    /// False if a place in the cube is not clear and open. True is nearly always right: it ignores the last bits of the
    /// planes.
    bool may_be_clear_and_open(const Vec3<World>& place) const {
        Child at = root_;
        while (at != Child::Solid && at != Child::Open) {
            const NearNode& node = item(nodes_, at);
            const PlaneDistance distance = plane_distance(*node.plane, place);
            if (absolute(distance) < kClearance) return false;
            at = node.children[distance > PlaneDistance{} ? 0 : 1];
        }
        return at == Child::Open;
    }

  private:
    enum class Child : std::int32_t { Open = -1, Solid = -2 };  ///< from 0 up: a node

    struct NearNode {
        const LevelPlane* plane;
        std::array<Child, 2> children;
    };

    Child add(const Level& level, NodeChild at, const Vec3<World>& middle, World half_size) {
        if (at.is_leaf()) return is_solid(level, at.leaf()) ? Child::Solid : Child::Open;
        const Node& node = level.nodes[at.node()];
        const LevelPlane& plane = level.planes[node.plane];
        const Vec3<Unit> slope{absolute(plane.normal.x), absolute(plane.normal.y), absolute(plane.normal.z)};
        const PlaneDistance distance = plane_distance(plane, middle);
        const PlaneDistance near_distance = dot(Vec3<World>{half_size, half_size, half_size}, slope) + kClearance;
        if (distance >= near_distance) return add(level, node.children[0], middle, half_size);
        if (-distance >= near_distance) return add(level, node.children[1], middle, half_size);
        const Child front = add(level, node.children[0], middle, half_size);
        const Child back = add(level, node.children[1], middle, half_size);
        if (front == Child::Solid && back == Child::Solid) return Child::Solid;
        nodes_.push_back({&plane, {front, back}});
        return static_cast<Child>(nodes_.size() - 1);
    }

    std::vector<NearNode> nodes_;
    Child root_;
};

/// Half an edge of the cubes of find_clear_place(), in steps.
constexpr std::int32_t kParts = 16;
constexpr std::array<std::int32_t, 4> kSteps{1, 2, 4, 8};

std::optional<PlacedEye> search_cube(const Level& level, const Vec3<World>& middle, std::int32_t step,
                                     const NearTree& near_tree) {
    for (std::int32_t x = -kParts; x <= kParts; ++x)
        for (std::int32_t y = -kParts; y <= kParts; ++y) {
            const bool is_side = std::max(std::abs(x), std::abs(y)) == kParts;
            for (std::int32_t z = -kParts; z <= kParts; z += is_side ? 1 : 2 * kParts) {
                const Vec3<World> place = middle + Vec3<World>{World::from_raw(x * step), World::from_raw(y * step),
                                                               World::from_raw(z * step)};
                if (!near_tree.may_be_clear_and_open(place) || !is_clear(level, place)) continue;
                const LeafIndex leaf = find_leaf(level, level.world(), place);
                if (!is_solid(level, leaf)) return PlacedEye{place, leaf};
            }
        }
    return std::nullopt;
}

}  // namespace

std::optional<PlacedEye> find_clear_place(const Level& level, const Vec3<World>& eye) {
    const NearTree near_tree(level, eye, World::from_raw(kParts * kSteps.back()));
    if (!near_tree.has_open_leaf()) return std::nullopt;
    for (const std::int32_t step : kSteps)
        if (const std::optional<PlacedEye> found = search_cube(level, eye, step, near_tree)) return found;
    return std::nullopt;
}

PlacedEye place_eye(const Level& level, Vec3<World> eye) {
    const Try first = move_clear(level, eye, 0);
    const bool was_clear = first.is_clear && first.placed.position == eye;  // in the open or deep in a wall
    if (was_clear || first.is_clear_and_open(level)) return first.placed;
    for (unsigned other_sides = 1; other_sides < 1u << kMostFlips; ++other_sides) {
        const Try other = move_clear(level, eye, other_sides);
        if (other.is_clear_and_open(level)) return other.placed;
    }
    return find_clear_place(level, eye).value_or(first.placed);
}

}  // namespace oblong
