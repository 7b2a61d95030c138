// The search for a clear place in sharp corners, which asks only the planes nearby, finds what asking the whole tree
// about every place finds.

#include "engine/visibility/eye.h"

#include <gtest/gtest.h>

#include "tests/visibility/visibility_fixture.h"

namespace oblong::test {

namespace {

constexpr auto kClearance = PlaneDistance::from_raw(std::int64_t{2} << 30);  // 2 steps of World

/// The leaf of a place that is clear of all planes above it and not solid.
std::optional<LeafIndex> clear_leaf(const Level& level, const Vec3<World>& place) {
    NodeChild at = level.world().root;
    while (!at.is_leaf()) {
        const Node& node = level.nodes[at.node()];
        const LevelPlane& plane = level.planes[node.plane];
        const bool in_front = plane_side(plane, place) > 0;
        const PlaneDistance distance = plane_distance(plane, place);
        if ((in_front ? distance : -distance) < kClearance) return std::nullopt;
        at = node.children[in_front ? 0 : 1];
    }
    if (level.leaves[at.leaf()].contents == contents::kSolid) return std::nullopt;
    return at.leaf();
}

std::optional<PlacedEye> asked_of_the_whole_tree(const Level& level, const Vec3<World>& eye) {
    for (std::int32_t step = 1; step <= 8; step *= 2)
        for (std::int32_t x = -16; x <= 16; ++x)
            for (std::int32_t y = -16; y <= 16; ++y)
                for (std::int32_t z = -16; z <= 16; ++z) {
                    if (std::max({std::abs(x), std::abs(y), std::abs(z)}) < 16) continue;
                    const Vec3<World> place = eye + Vec3<World>{World::from_raw(x * step), World::from_raw(y * step),
                                                                World::from_raw(z * step)};
                    if (const auto leaf = clear_leaf(level, place)) return PlacedEye{place, *leaf};
                }
    return std::nullopt;
}

/// A point up to 200 steps from a corner of the level: the fewer the likelier.
Vec3<World> near_a_corner(const Level& level, std::mt19937& random) {
    const Vec3<World> corner = level.vertices[VertexIndex(random_below(random, level.vertices.count()))];
    const std::int32_t most = std::array{0, 1, 8, 30, 200}[random() % 5];
    const auto off = [&] { return World::from_raw(random_below(random, 2 * most + 1) - most); };
    return corner + Vec3<World>{off(), off(), off()};
}

class ClearPlace : public OfLevel {};

}  // namespace

TEST_P(ClearPlace, IsThatFoundInTheWholeTree) {
    const Level level = read_level(GetParam());
    std::mt19937 random(6);
    int found_count = 0, farther_count = 0, none_count = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec3<World> eye = near_a_corner(level, random);
        const std::optional<PlacedEye> expected = asked_of_the_whole_tree(level, eye);
        const std::optional<PlacedEye> found = find_clear_place(level, eye);
        ASSERT_EQ(found.has_value(), expected.has_value()) << i;
        ++(found ? found_count : none_count);
        if (!found) continue;
        ASSERT_EQ(found->position, expected->position) << i;
        ASSERT_EQ(found->leaf, expected->leaf) << i;
        farther_count += std::abs((found->position.x - eye.x).raw) > 16;
    }
    EXPECT_GT(found_count, 0);
    EXPECT_GT(farther_count, 0);
    EXPECT_GT(none_count, 0);
}

OBLONG_FOR_ALL_LEVELS(ClearPlace);

}  // namespace oblong::test
