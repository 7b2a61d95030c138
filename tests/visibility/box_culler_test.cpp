// Boxes against the sides of a view, corner by corner.
#include "engine/visibility/box_culler.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/visibility/visibility_fixture.h"

namespace oblong::test {

namespace {

struct Culling {
    Frustum frustum;
    Vec3<World> eye;
};

Culling random_culling(std::mt19937& random, std::int32_t reach) {
    const auto coordinate = [&] {
        return World::from_raw(static_cast<std::int32_t>(random() % (static_cast<std::uint32_t>(reach) * 8192)) -
                               reach * 4096);
    };
    const Basis axes = random_axes(random);
    const Projection projection = make_projection(ScreenMode{}, Degrees::from_int(1 + random() % 179));
    const View parallel_depth = random() % 4 ? View{} : View::from_int(1 << random() % 20);
    return {make_frustum(axes, projection, parallel_depth), {coordinate(), coordinate(), coordinate()}};
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

}  // namespace oblong::test
