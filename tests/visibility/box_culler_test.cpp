#include "engine/visibility/box_culler.h"

#include <gtest/gtest.h>

#include "engine/visibility/visible_set.h"
#include "tests/visibility/visibility_fixture.h"

namespace oblong::test::box_rectangle_test {
namespace {

// Boxes against the sides of a view, corner by corner.

struct Culling {
    Frustum frustum;
    Vec3<World> eye;
};

Vec3<World> random_eye(std::mt19937& random, std::int32_t reach) {
    const auto coordinate = [&] {
        return World::from_raw(static_cast<std::int32_t>(random() % (static_cast<std::uint32_t>(reach) * 8192)) -
                               reach * 4096);
    };
    return {coordinate(), coordinate(), coordinate()};
}

Culling random_culling(std::mt19937& random, std::int32_t reach) {
    const Basis axes = random_axes(random);
    const Projection projection = make_projection(ScreenMode{}, Degrees::from_int(1 + random() % 179));
    const View parallel_depth = random() % 4 ? View{} : View::from_int(1 << random() % 20);
    return {make_frustum(axes, projection, parallel_depth), random_eye(random, reach)};
}

/// normal . (corner - eye) of the corner that takes the greater bound along the axes of `high`.
CullDistance corner_distance(const CullPlane& plane, const LevelBox& box, const Vec3<World>& eye, unsigned high) {
    const std::array at{eye.x, eye.y, eye.z};
    const std::array normal{plane.normal.x, plane.normal.y, plane.normal.z};
    CullDistance sum;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int32_t bound = high >> axis & 1 ? box.maxs[axis] : box.mins[axis];
        sum += bounded_product(normal[axis], WorldWide::from_int(bound) - convert<WorldWide>(at[axis]));
    }
    return sum;
}

std::uint8_t crossed_by_corners(const Culling& culling, const LevelBox& box, std::uint8_t planes) {
    unsigned crossed = planes;
    for (unsigned side = 0; side < 4; ++side) {
        if (!(planes >> side & 1)) continue;
        const CullPlane& plane = culling.frustum.cull_planes[side];
        unsigned outside = 0, inside = 0;
        for (unsigned corner = 0; corner < 8; ++corner) {
            const CullDistance distance = corner_distance(plane, box, culling.eye, corner);
            outside += distance < plane.outside;
            inside += distance >= plane.inside;
        }
        if (outside == 8) return kOutside;
        if (inside == 8) crossed &= ~(1u << side);
    }
    return static_cast<std::uint8_t>(crossed);
}

struct Tally {
    int outside = 0, inside = 0, crossing = 0;
};

Tally compare(std::int32_t reach, std::int32_t largest) {
    std::mt19937 random(3);
    Tally tally;
    for (int view = 0; view < 300; ++view) {
        const Culling culling = random_culling(random, reach);
        const BoxCuller culler(culling.frustum, culling.eye);
        for (int i = 0; i < 200; ++i) {
            const LevelBox box = random_box(random, reach, largest);
            const auto planes = static_cast<std::uint8_t>(random() % 16);
            const std::uint8_t expected = crossed_by_corners(culling, box, planes);
            EXPECT_EQ(culler.sides_crossed(box, planes), expected);
            ++(expected == kOutside ? tally.outside : expected == 0 ? tally.inside : tally.crossing);
        }
    }
    return tally;
}

void expect_all_kinds(const Tally& tally) {
    EXPECT_GT(tally.outside, 100);
    EXPECT_GT(tally.inside, 100);
    EXPECT_GT(tally.crossing, 100);
}

// Boxes among leaves, against points of them.

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

/// Of a world that reaches `reach` units either way.
ViewContext random_view(std::mt19937& random, std::int32_t reach = 2000) {
    return view_along(random_eye(random, reach), random_axes(random), {}, 20 + random_below(random, 130));
}

/// Column and row, in doubles, of a point of the box; behind the eye they are not on the screen.
std::pair<double, double> seen_at(const ViewContext& view, const Point& p) {
    const Point way = p - to_point(view.eye);
    const double depth = dot(way, to_point(view.axes.forward));
    if (depth <= 0) return {-1, -1};
    return {160 + number_of(view.projection.x.multiplier) * dot(way, to_point(view.axes.right)) / depth,
            100 - number_of(view.projection.y.multiplier) * dot(way, to_point(view.axes.up)) / depth};
}

struct Seen {
    int on_screen = 0, small = 0;
};

/// Points of random boxes, in doubles, are in the boxes' rectangles.
Seen check_boxes(std::int32_t reach, std::int32_t largest) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> part(0, 1);
    Seen tally;
    for (int trial = 0; trial < 20000; ++trial) {
        const ViewContext view = random_view(random, reach);
        const LevelBox box = random_box(random, reach, largest);
        const ScreenRectangle rectangle = rectangle_of(box, view);
        tally.small +=
            (rectangle.end_column - rectangle.first_column) * (rectangle.end_row - rectangle.first_row) < 6400;
        for (int point = 0; point < 8; ++point) {
            const auto at = [&](std::size_t axis) {
                const double along = trial % 2 ? std::round(part(random)) : part(random);
                return box.mins[axis] + along * (box.maxs[axis] - box.mins[axis]);
            };
            const auto [column, row] = seen_at(view, {at(0), at(1), at(2)});
            if (column < 0 || column >= 320 || row < 0 || row >= 200) continue;
            ++tally.on_screen;
            EXPECT_GE(column, rectangle.first_column);
            EXPECT_LE(column, rectangle.end_column);
            EXPECT_GE(row, rectangle.first_row);
            EXPECT_LE(row, rectangle.end_row);
        }
    }
    return tally;
}

}  // namespace

TEST(BoxCuller, AgreesWithTheEightCorners) {
    expect_all_kinds(compare(2000, 600));
    expect_all_kinds(compare(40, 6));
}

TEST(BoxCuller, AgreesInTheLargestWorld) {
    expect_all_kinds(compare(524'287, 300'000));
}

/// Limits are rounded to the steps of what is compared with them: boxes that touch them from either side.
TEST(BoxCuller, AgreesAtTheLimits) {
    std::mt19937 random(4);
    int at_limits = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        Culling culling = random_culling(random, 300);
        const LevelBox box = random_box(random, 300, 50);
        CullPlane& plane = culling.frustum.cull_planes[trial % 4];
        CullDistance farthest = CullDistance::lowest(), nearest = CullDistance::highest();
        for (unsigned corner = 0; corner < 8; ++corner) {
            farthest = std::max(farthest, corner_distance(plane, box, culling.eye, corner));
            nearest = std::min(nearest, corner_distance(plane, box, culling.eye, corner));
        }
        for (const std::int64_t beside : {-1, 0, 1}) {
            plane.outside = farthest + CullDistance::from_raw(beside);
            plane.inside = nearest + CullDistance::from_raw(beside);
            const auto planes = static_cast<std::uint8_t>(1u << trial % 4);
            const std::uint8_t expected = crossed_by_corners(culling, box, planes);
            EXPECT_EQ(BoxCuller(culling.frustum, culling.eye).sides_crossed(box, planes), expected);
            at_limits += expected != planes;
        }
    }
    EXPECT_GT(at_limits, 4000);
}

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

TEST(BoxRectangle, HoldsAllOfTheBoxThatIsOnTheScreen) {
    const Seen tally = check_boxes(2000, 300);
    EXPECT_GT(tally.on_screen, 1000);
    EXPECT_GT(tally.small, 1000) << "a rectangle that is always large hides nothing";
}

TEST(BoxRectangle, HoldsBoxesAsLargeAsTheWorld) {
    EXPECT_GT(check_boxes(524'287, 80'000).on_screen, 1000);
    EXPECT_GT(check_boxes(524'287, 2 * 524'287).on_screen, 1000);
}

/// Boxes around the eye and beside it.
TEST(BoxRectangle, HoldsBoxesNearTheEye) {
    const Seen tally = check_boxes(40, 60);
    EXPECT_GT(tally.on_screen, 1000);
    EXPECT_GT(tally.small, 1000);
}

/// As wide as BSP2 files may have it, before the eye and past it.
TEST(BoxRectangle, OfTheWholeWorldIsTheScreen) {
    constexpr std::int32_t kFar = 524'287;
    std::mt19937 random(11);
    for (int trial = 0; trial < 1000; ++trial) {
        const ScreenRectangle pixels =
            rectangle_of({{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}}, random_view(random, kFar - 2));
        EXPECT_TRUE(pixels.first_column == 0 && pixels.end_column == 320);
        EXPECT_TRUE(pixels.first_row == 0 && pixels.end_row == 200);
    }
}
}  // namespace oblong::test::box_rectangle_test
