// Boxes among leaves, against points of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/visibility/box_culler.h"
#include "engine/visibility/visible_set.h"
#include "tests/visibility/visibility_fixture.h"

namespace oblong::test {

namespace {

BoxCuller culler_of(const ViewContext& view) {
    return {view.frustum, view.eye};
}

LevelBox box_around(const Vec3<World>& middle, std::int32_t half) {
    const std::array at{floor_of(middle.x), floor_of(middle.y), floor_of(middle.z)};
    return {{at[0] - half, at[1] - half, at[2] - half}, {at[0] + half, at[1] + half, at[2] + half}};
}

bool has_leaf(const PlacedBox& placed, LeafIndex leaf) {
    return std::find(placed.leaves.begin(), placed.leaves.end(), leaf) != placed.leaves.end();
}

}  // namespace

class PlacedBoxOf : public OfLevel {};

TEST_P(PlacedBoxOf, HasTheLeafOfEachOfItsPoints) {
    const Level level = read_level(GetParam());
    std::mt19937 random(1);
    for (int trial = 0; trial < 100; ++trial) {
        const PlacedBox placed = place_box(level, box_around(random_open_point(level, random), 1 << random() % 7));
        ASSERT_FALSE(placed.has_many_leaves);
        for (int i = 0; i < 50; ++i) {
            const LeafIndex leaf = find_leaf(level, level.world(), random_point_in(placed.box, random));
            const bool is_solid = level.leaves[leaf].contents == contents::kSolid;
            ASSERT_EQ(has_leaf(placed, leaf), !is_solid);
        }
    }
}

TEST_P(PlacedBoxOf, MayBeSeenIfAPointOfItIsInViewInAVisibleLeaf) {
    const Level level = read_level(GetParam());
    std::mt19937 random(2);
    VisibleSet visible(level);
    int seen = 0, unseen = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Vec3<World> eye = random_open_point(level, random);
        visible.see_from(level, find_leaf(level, level.world(), eye));
        const ViewContext view = view_from(eye, Angle::from_bam(random()));
        const PlacedBox placed = place_box(level, box_around(random_open_point(level, random), 40));
        const bool may_be = may_be_seen(placed, visible.leaf_set(), culler_of(view));
        (may_be ? seen : unseen) += 1;
        if (may_be) continue;
        for (int i = 0; i < 20; ++i) {
            const Vec3<World> p = random_point_in(placed.box, random);
            const bool is_in_view = outcode_of(view.frustum, to_view(p, eye, view.axes)) == 0;
            ASSERT_FALSE(is_in_view && visible.has_leaf(find_leaf(level, level.world(), p)));
        }
    }
    EXPECT_GT(seen, 20);
    EXPECT_GT(unseen, 500);
}

TEST_P(PlacedBoxOf, HasNoListWhereItHoldsTheWholeLevel) {
    const Level level = read_level(GetParam());
    const PlacedBox placed = place_box(level, {{-500000, -500000, -500000}, {500000, 500000, 500000}});
    EXPECT_TRUE(placed.has_many_leaves && placed.leaves.empty());
    VisibleSet visible(level);
    std::mt19937 random(3);
    const Vec3<World> eye = random_open_point(level, random);
    visible.see_from(level, find_leaf(level, level.world(), eye));
    EXPECT_TRUE(may_be_seen(placed, visible.leaf_set(), culler_of(view_from(eye, {}))));
}

OBLONG_FOR_REAL_LEVELS(PlacedBoxOf);

}  // namespace oblong::test
