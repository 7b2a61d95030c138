#include <gtest/gtest.h>

#include "engine/level/trace.h"
#include "tests/support/levels.h"
#include "tests/support/point.h"

namespace oblong {
namespace {

using test::along, test::Point, test::to_point, test::to_world;

class RealTrace : public test::OfLevel {
  protected:
    void SetUp() override {
        OfLevel::SetUp();
        if (!IsSkipped()) level_ = test::read_level(GetParam());
    }
    const SubModel& world() const { return level_.world(); }
    Vec3<World> random_point() { return test::random_point_in(world().box, random_); }

    /// Calls check(hull, from, to) for random ways that start outside solid, short ones and long ones.
    template <class Check>
    void for_random_ways(int count, Check check) {
        for (const Hull hull : {Hull::Point, Hull::Player, Hull::Large}) {
            for (int i = 0; i < count;) {
                const Vec3<World> from = random_point();
                if (hull_contents(level_, world(), hull, from) == contents::kSolid) continue;
                const Vec3<World> far = random_point(), way = far - from;
                const std::int32_t divisor = 1 << (i % 6);
                const auto shorten = [divisor](World part) { return World::from_raw(part.raw / divisor); };
                check(hull, from, from + Vec3<World>{shorten(way.x), shorten(way.y), shorten(way.z)});
                ++i;
            }
        }
    }

    Level level_;
    std::mt19937 random_{3};
};

TEST_P(RealTrace, ContentsOfThePointHullAreThoseOfTheLeaf) {
    for (int i = 0; i < 5000; ++i) {
        const Vec3<World> p = random_point();
        const Leaf& leaf = level_.leaves[find_leaf(level_, world(), p)];
        ASSERT_EQ(hull_contents(level_, world(), Hull::Point, p), leaf.contents);
    }
}

TEST_P(RealTrace, NeverEndsInSolidAndStaysOnItsWay) {
    int hits = 0;
    for_random_ways(4000, [&](Hull hull, Vec3<World> from, Vec3<World> to) {
        const TraceResult result = trace_hull(level_, world(), hull, from, to);
        hits += result.is_hit;
        ASSERT_FALSE(result.starts_solid);
        ASSERT_NE(hull_contents(level_, world(), hull, result.end), contents::kSolid);
        const double fraction = result.fraction.raw * 0x1p-30;
        ASSERT_TRUE(fraction >= 0 && fraction <= 1);
        const Point on_way = along(to_point(from), to_point(to), fraction), end = to_point(result.end);
        const Point off = end - on_way;
        ASSERT_LE(dot(off, off), 0.01 * 0.01);
        ASSERT_TRUE(result.is_hit || result.end == to);
    });
    EXPECT_GT(hits, 4000);
}

// No wall is passed, however thin.
TEST_P(RealTrace, PassesThroughNothingSolid) {
    int solid = 0;
    for_random_ways(1000, [&](Hull hull, Vec3<World> from, Vec3<World> to) {
        const TraceResult result = trace_hull(level_, world(), hull, from, to);
        for (int i = 1; i < 64; ++i) {
            const Vec3<World> p = to_world(along(to_point(from), to_point(result.end), i / 64.));
            solid += hull_contents(level_, world(), hull, p) == contents::kSolid;
        }
    });
    EXPECT_EQ(solid, 0);
}

TEST_P(RealTrace, StoppedItSlidesAlongThePlaneAndGoesBack) {
    for_random_ways(2000, [&](Hull hull, Vec3<World> from, Vec3<World> to) {
        const TraceResult result = trace_hull(level_, world(), hull, from, to);
        if (!result.is_hit) return;
        const Point way = to_point(to) - to_point(from), n = to_point(result.normal);
        ASSERT_LT(dot(way, n), 0) << "the normal faces the body";
        const Point slide = to_point(result.end) + way - n * dot(way, n);
        const TraceResult slid = trace_hull(level_, world(), hull, result.end, to_world(slide));
        ASSERT_FALSE(slid.starts_solid);
        ASSERT_NE(hull_contents(level_, world(), hull, slid.end), contents::kSolid);
        ASSERT_FALSE(trace_hull(level_, world(), hull, result.end, from).starts_solid);
    });
}

// A way that is free is free backwards too, but for ways that pass an edge closer than the 1/32 unit kept.
TEST_P(RealTrace, FreeWaysAreFreeBackwards) {
    int free = 0, blocked_backwards = 0;
    for_random_ways(3000, [&](Hull hull, Vec3<World> from, Vec3<World> to) {
        if (trace_hull(level_, world(), hull, from, to).is_hit) return;
        ++free;
        blocked_backwards += trace_hull(level_, world(), hull, to, from).is_hit;
    });
    EXPECT_GT(free, 500);
    EXPECT_LE(blocked_backwards, free / 1000);
}

OBLONG_FOR_REAL_LEVELS(RealTrace);

}  // namespace
}  // namespace oblong
