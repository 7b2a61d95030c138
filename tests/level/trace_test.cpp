#include "engine/level/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/level/bsp_read.h"
#include "engine/level/side.h"
#include "tests/support/shared_levels.h"
#include "tests/support/tiny_bsp.h"

namespace oblong {
namespace {

struct Point {
    double x = 0, y = 0, z = 0;
};

double dot(Point a, Point b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Point along(Point a, Point b, double t) {
    return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t};
}

struct FilePlane {
    Point normal;
    double distance;
    double from(Point p) const { return dot(normal, p) - distance; }
};

Vec3<World> to_world(Point p) {
    const auto part = [](double value) {
        return World::from_raw(static_cast<std::int32_t>(std::lround(value * 4096)));
    };
    return {part(p.x), part(p.y), part(p.z)};
}
Point to_point(Vec3<World> p) {
    return {p.x.raw / 4096., p.y.raw / 4096., p.z.raw / 4096.};
}

/// A level whose Player hull is a chain of planes: in front of all of them (`inside_is_solid` false: a room) is empty
/// and the rest solid, or behind all of them (a block) is solid and the rest empty.
Level make_convex(const std::vector<FilePlane>& planes, bool inside_is_solid) {
    test::Lumps lumps = test::make_tiny_lumps();
    test::Bytes& nodes = test::lump_of(lumps, Lump::ClipNodes);
    nodes.clear();
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const Point n = planes[i].normal;
        const auto part = [](double value) { return static_cast<float>(value); };
        test::ByteWriter(test::lump_of(lumps, Lump::Planes)).f32(part(n.x)).f32(part(n.y)).f32(part(n.z));
        test::ByteWriter(test::lump_of(lumps, Lump::Planes)).f32(part(planes[i].distance)).i32(3);
        const bool is_last = i + 1 == planes.size();
        const auto next = static_cast<std::int64_t>(i + 1);
        test::ByteWriter out(nodes);
        out.i32(next);  // plane 0 is the tiny level's floor
        if (inside_is_solid)
            out.i16(contents::kEmpty).i16(is_last ? contents::kSolid : next);
        else
            out.i16(is_last ? contents::kEmpty : next).i16(contents::kSolid);
    }
    return read_bsp(test::join_lumps(29, lumps));
}

/// Six sides of a box from -size to size, facing out (1) or in (-1).
std::vector<FilePlane> box_planes(double size, double facing) {
    std::vector<FilePlane> planes;
    for (const double side : {1., -1.}) {
        const double n = side * facing;
        for (const Point normal : {Point{n, 0, 0}, Point{0, n, 0}, Point{0, 0, n}})
            planes.push_back({normal, size * facing});
    }
    return planes;
}

TraceResult trace(const Level& level, Point from, Point to) {
    return trace_hull(level, level.models[0], Hull::Player, to_world(from), to_world(to));
}

TEST(Trace, StopsA32ndBeforeTheWallOfARoom) {
    const Level room = make_convex(box_planes(100, -1), false);
    const TraceResult result = trace(room, {0, 10, 20}, {200, 10, 20});
    EXPECT_EQ(result.end, to_world({100 - 1. / 32, 10, 20}));
    EXPECT_NEAR(result.fraction.raw * 0x1p-30, (100 - 1. / 32) / 200, 0x1p-29);
    EXPECT_EQ(result.normal, (Vec3<Unit>{Unit::from_int(-1), Unit::from_int(0), Unit::from_int(0)}));
    EXPECT_TRUE(result.is_hit);
    EXPECT_FALSE(result.starts_solid);
    EXPECT_FALSE(result.is_all_solid);
}

TEST(Trace, GoesAllTheWayWhereNothingIs) {
    const Level room = make_convex(box_planes(100, -1), false);
    const TraceResult result = trace(room, {-99, -99, -99}, {99, 98, 97});
    EXPECT_EQ(result.end, to_world({99, 98, 97}));
    EXPECT_EQ(result.fraction, Unit::from_int(1));
    EXPECT_FALSE(result.is_hit);
}

TEST(Trace, NearerThanA32ndItStaysAndMayLeave) {
    const Level room = make_convex(box_planes(100, -1), false);
    const Point near{100 - 1. / 64, 0, 0};
    EXPECT_EQ(trace(room, near, {101, 0, 0}).end, to_world(near));
    EXPECT_EQ(trace(room, near, {101, 0, 0}).fraction.raw, 0);
    EXPECT_FALSE(trace(room, near, {-50, 0, 0}).is_hit);
    EXPECT_FALSE(trace(room, near, {100 - 1. / 64, 50, 50}).is_hit) << "along the wall";
}

TEST(Trace, MeetsABlockFromEverySide) {
    const Level block = make_convex(box_planes(32, 1), true);
    const double stop = 32 + 1. / 32;
    EXPECT_EQ(trace(block, {-100, 0, 0}, {100, 0, 0}).end, to_world({-stop, 0, 0}));
    EXPECT_EQ(trace(block, {100, 5, 0}, {-100, 5, 0}).end, to_world({stop, 5, 0}));
    EXPECT_EQ(trace(block, {0, 0, 1000}, {0, 0, -1000}).end, to_world({0, 0, stop}));
    EXPECT_EQ(trace(block, {0, 0, 1000}, {0, 0, -1000}).normal.z, Unit::from_int(1));
    EXPECT_FALSE(trace(block, {-100, 33, 0}, {100, 33, 0}).is_hit) << "past it";
}

TEST(Trace, FromSolidItMovesOutAndThroughSolidItStays) {
    const Level block = make_convex(box_planes(32, 1), true);
    const TraceResult out = trace(block, {0, 0, 0}, {100, 0, 0});
    EXPECT_TRUE(out.starts_solid);
    EXPECT_FALSE(out.is_all_solid);
    EXPECT_EQ(out.end, to_world({100, 0, 0}));
    const TraceResult stuck = trace(block, {0, 0, 0}, {10, 10, 10});
    EXPECT_TRUE(stuck.starts_solid);
    EXPECT_TRUE(stuck.is_all_solid);
    EXPECT_EQ(stuck.end, to_world({0, 0, 0}));
    EXPECT_EQ(stuck.fraction.raw, 0);
}

TEST(Trace, PointOnAPlaneBelongsToItsFront) {
    const Level block = make_convex(box_planes(32, 1), true);
    const auto contents_at = [&block](Point p) {
        return hull_contents(block, block.models[0], Hull::Player, to_world(p));
    };
    EXPECT_EQ(contents_at({32, 0, 0}), contents::kEmpty);
    EXPECT_EQ(contents_at({32 - 1. / 4096, 0, 0}), contents::kSolid);
}

/// Planes of random directions that touch a sphere of `radius` around the origin, facing in.
std::vector<FilePlane> random_room(std::mt19937& random, double radius, int count) {
    std::normal_distribution<double> part;
    std::vector<FilePlane> planes;
    for (int i = 0; i < count; ++i) {
        const Point n{part(random), part(random), part(random)};
        const double length = std::sqrt(dot(n, n));
        planes.push_back(
            {{static_cast<float>(n.x / length), static_cast<float>(n.y / length), static_cast<float>(n.z / length)},
             -radius});
    }
    return planes;
}

Point random_point(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> part(-size, size);
    const double x = part(random), y = part(random);
    return to_point(to_world({x, y, part(random)}));
}

/// How near a point is to the nearest wall; negative behind it.
double clearance(const std::vector<FilePlane>& room, Point p) {
    double least = 1e9;
    for (const FilePlane& plane : room) least = std::min(least, plane.from(p));
    return least;
}

/// In a convex room the answer has a closed form: the first place 1/32 before a plane that the way ends behind.
Point first_stop(const std::vector<FilePlane>& room, Point from, Point to) {
    double fraction = 1;
    for (const FilePlane& plane : room) {
        const double near = plane.from(from), far = plane.from(to);
        if (far < 0) fraction = std::min(fraction, (near - 1. / 32) / (near - far));
    }
    return along(from, to, fraction);
}

// A few ways reach two planes at once: having stopped before one, the body no longer comes to the other, from which it
// then keeps less than 1/32, but never nothing.
TEST(Trace, AgreesWithTheClosedFormInRandomRooms) {
    std::mt19937 random(11);
    int beyond_rounding = 0;
    for (int round = 0; round < 200; ++round) {
        const std::vector<FilePlane> planes = random_room(random, 60, 12);
        const Level room = make_convex(planes, false);
        for (int i = 0; i < 50; ++i) {
            const Point from = random_point(random, 30), to = random_point(random, 500);
            const Point end = to_point(trace(room, from, to).end), expected = first_stop(planes, from, to);
            const Point off{end.x - expected.x, end.y - expected.y, end.z - expected.z};
            const double difference = std::sqrt(dot(off, off));
            EXPECT_GE(clearance(planes, end), 0) << "behind a plane";
            EXPECT_LE(difference, 1. / 16);
            beyond_rounding += difference > 4. / 4096;
        }
    }
    EXPECT_LE(beyond_rounding, 25) << "of 10,000";
}

class RealTrace : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        OBLONG_NEEDS_SHARED_LEVELS();
        level_ = read_bsp(test::read_shared_file(std::string(GetParam()) + ".bsp"));
    }

    const SubModel& world() const { return level_.models[0]; }

    Vec3<World> random_point() {
        const auto part = [this](std::size_t axis) {
            const LevelBox& box = world().box;
            std::uniform_int_distribution<std::int32_t> raw(box.mins[axis] * 4096, box.maxs[axis] * 4096);
            return World::from_raw(raw(random_));
        };
        const World x = part(0), y = part(1);
        return {x, y, part(2)};
    }

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
        const std::int32_t leaf = find_leaf(level_, world(), p);
        ASSERT_EQ(hull_contents(level_, world(), Hull::Point, p),
                  level_.leaves[static_cast<std::size_t>(leaf)].contents);
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
        const Point off{end.x - on_way.x, end.y - on_way.y, end.z - on_way.z};
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
        const Point way{to_point(to).x - to_point(from).x, to_point(to).y - to_point(from).y,
                        to_point(to).z - to_point(from).z};
        const Point n{result.normal.x.raw * 0x1p-30, result.normal.y.raw * 0x1p-30, result.normal.z.raw * 0x1p-30};
        ASSERT_LT(dot(way, n), 0) << "the normal faces the body";
        const Point end = to_point(result.end);
        const double into = dot(way, n);
        const Point slide{end.x + way.x - n.x * into, end.y + way.y - n.y * into, end.z + way.z - n.z * into};
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

INSTANTIATE_TEST_SUITE_P(Shared, RealTrace, testing::ValuesIn(test::kRealLevels));

}  // namespace
}  // namespace oblong
