// The floor below a point against what fills the level at points further and further down.

#include "engine/level/trace.h"

#include <gtest/gtest.h>

#include "tests/support/levels.h"

namespace oblong::test {
namespace {

struct FilePlane {
    Point normal;
    double distance;
    double from(Point p) const { return dot(normal, p) - distance; }
};

/// A level whose Player hull is a chain of planes: in front of all of them (`inside_is_solid` false: a room) is empty
/// and the rest solid, or behind all of them (a block) is solid and the rest empty.
Level make_convex(const std::vector<FilePlane>& planes, bool inside_is_solid) {
    Lumps lumps = make_tiny_lumps();
    Bytes& nodes = lump_of(lumps, Lump::ClipNodes);
    nodes.clear();
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const Point n = planes[i].normal;
        const auto part = [](double value) { return static_cast<float>(value); };
        ByteWriter(lump_of(lumps, Lump::Planes)).f32(part(n.x)).f32(part(n.y)).f32(part(n.z));
        ByteWriter(lump_of(lumps, Lump::Planes)).f32(part(planes[i].distance)).i32(3);
        const bool is_last = i + 1 == planes.size();
        const auto next = static_cast<std::int64_t>(i + 1);
        ByteWriter out(nodes);
        out.i32(next);  // plane 0 is the tiny level's floor
        if (inside_is_solid)
            out.i16(contents::kEmpty).i16(is_last ? contents::kSolid : next);
        else
            out.i16(is_last ? contents::kEmpty : next).i16(contents::kSolid);
    }
    return read_bsp(join_lumps(29, lumps));
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
    return trace_hull(level, level.world(), Hull::Player, to_world(from), to_world(to));
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

/// Ways in a room 200 units wide, and around a block of 64, that end where they would or before.
TEST(Trace, EndsA32ndBeforeWhatItMeets) {
    const Level room = make_convex(box_planes(100, -1), false), block = make_convex(box_planes(32, 1), true);
    constexpr double kStop = 32 + 1. / 32, kNear = 100 - 1. / 64;
    struct Way {
        const char* what;
        const Level& level;
        Point from, to, end;
    };
    for (const auto& [what, level, from, to, end] :
         {Way{"where nothing is", room, {-99, -99, -99}, {99, 98, 97}, {99, 98, 97}},
          {"nearer than a 32nd it stays", room, {kNear, 0, 0}, {101, 0, 0}, {kNear, 0, 0}},
          {"and may leave", room, {kNear, 0, 0}, {-50, 0, 0}, {-50, 0, 0}},
          {"along the wall", room, {kNear, 0, 0}, {kNear, 50, 50}, {kNear, 50, 50}},
          {"to nearer than a 32nd", room, {0, 0, 0}, {kNear, 0, 0}, {kNear, 0, 0}},
          {"on the plane is in front", room, {0, 0, 0}, {100, 0, 0}, {100, 0, 0}},
          {"behind the plane", room, {0, 0, 0}, {100 + 1. / 4096, 0, 0}, {100 - 1. / 32, 0, 0}},
          {"a block from one side", block, {-100, 0, 0}, {100, 0, 0}, {-kStop, 0, 0}},
          {"and the other", block, {100, 5, 0}, {-100, 5, 0}, {kStop, 5, 0}},
          {"from above", block, {0, 0, 1000}, {0, 0, -1000}, {0, 0, kStop}},
          {"past it", block, {-100, 33, 0}, {100, 33, 0}, {100, 33, 0}}}) {
        const TraceResult result = trace(level, from, to);
        EXPECT_EQ(result.end, to_world(end)) << what;
        EXPECT_EQ(result.is_hit, end != to) << what;
        EXPECT_NEAR(number_of(result.fraction), length(end - from) / length(to - from), 0x1p-20) << what;
    }
    EXPECT_EQ(trace(room, {kNear, 0, 0}, {101, 0, 0}).fraction.raw, 0);
    EXPECT_EQ(trace(block, {0, 0, 1000}, {0, 0, -1000}).normal.z, Unit::from_int(1));
}

// Solid from x = 1/51 or 1/33 down to 0, and from -1/64 down. The point 1/32 before the latter is inside the former,
// which a line cut 1/32 before x = 0 has not seen: it must back off, by 3 or all 10 steps.
TEST(Trace, BacksOffFromAStopInsideSolid) {
    for (const float front : {1.F / 51, 1.F / 33}) {
        Lumps lumps = make_tiny_lumps();
        for (const float distance : {0.F, front, -1.F / 64})
            ByteWriter(lump_of(lumps, Lump::Planes)).f32(1).f32(0).f32(0).f32(distance).i32(0);
        Bytes& nodes = lump_of(lumps, Lump::ClipNodes);
        nodes.clear();
        ByteWriter(nodes).i32(1).i16(1).i16(2);
        for (const int plane : {2, 3}) ByteWriter(nodes).i32(plane).i16(contents::kEmpty).i16(contents::kSolid);
        const Level level = read_bsp(join_lumps(29, lumps));

        const TraceResult result = trace(level, {10, 0, 0}, {-10, 0, 0});
        EXPECT_TRUE(result.is_hit);
        EXPECT_EQ(hull_contents(level, level.world(), Hull::Player, result.end), contents::kEmpty);
        EXPECT_LE(to_point(result.end).x, 1. / 32 + 1. / 4096);
    }
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
        return hull_contents(block, block.world(), Hull::Player, to_world(p));
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
        const Point one = normalised(n);
        planes.push_back({{static_cast<float>(one.x), static_cast<float>(one.y), static_cast<float>(one.z)}, -radius});
    }
    return planes;
}

Point random_point(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> part(-size, size);
    const double x = part(random), y = part(random);
    return to_point(point_at(x, y, part(random)));
}

/// How near a point is to the nearest wall that `to` is behind, or to any; negative behind it.
double clearance(const std::vector<FilePlane>& room, Point p, const Point* to = nullptr) {
    double least = 1e9;
    for (const FilePlane& plane : room)
        if (to == nullptr || plane.from(*to) < 0) least = std::min(least, plane.from(p));
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
// then keeps less than 1/32, but never nothing. How much farther it goes has no bound, if it grazes the other.
TEST(Trace, AgreesWithTheClosedFormInRandomRooms) {
    constexpr double kRounding = 4. / 4096;
    std::mt19937 random(11);
    int farther = 0;
    for (int round = 0; round < 200; ++round) {
        const std::vector<FilePlane> planes = random_room(random, 60, 12);
        const Level room = make_convex(planes, false);
        for (int i = 0; i < 50; ++i) {
            const Point from = random_point(random, 30), to = random_point(random, 500);
            const Point end = to_point(trace(room, from, to).end), expected = first_stop(planes, from, to);
            EXPECT_GE(clearance(planes, end), 0) << "behind a plane";
            const double way = dot(end - expected, normalised(to - from));
            EXPECT_TRUE(end == to || clearance(planes, end, &to) <= 1. / 32 + kRounding) << "stopped too early";
            EXPECT_LE(length(end - expected - normalised(to - from) * way), kRounding) << "beside the way";
            farther += way > kRounding;
        }
    }
    EXPECT_LE(farther, 25) << "of 10,000";
}

Vec3<World> at_height(std::int32_t z) {
    return point_at(16, 8, z);
}

}  // namespace

TEST(Floor, IsFoundBelowAPoint) {
    const Level level = tiny_level();
    const auto floor = find_floor(level, at_height(100), World::from_int(128));
    ASSERT_TRUE(floor);
    EXPECT_EQ(floor->position, at_height(8));
    EXPECT_EQ(floor->plane, PlaneIndex(0));
}

TEST(Floor, IsNotFoundTooFarBelowOrFromSolid) {
    const Level level = tiny_level();
    for (const auto& [from, most, is_found] : {std::tuple{at_height(136), 129, true},
                                               {at_height(136), 128, false},
                                               {at_height(136), 127, false},
                                               {at_height(4), 128, false},
                                               {point_at(0, 0, -524288), 128, false}})
        EXPECT_EQ(find_floor(level, from, World::from_int(most)).has_value(), is_found) << from.z.raw << ", " << most;
}

TEST(Floor, IsWhereSolidBeginsInRealLevels) {
    OBLONG_NEEDS_SHARED_LEVELS();
    constexpr std::int32_t kMost = 128, kStep = 4096 / 2;
    for (const char* name : kRealLevels) {
        const Level level = read_level(name);
        std::mt19937 random(1);
        int found = 0, missed = 0;
        for (int trial = 0; trial < 20000; ++trial) {
            const Vec3<World> from = random_point_in(level.world().box, random);
            const auto contents_below = [&](std::int32_t raw) {
                const Vec3<World> p{from.x, from.y, World::from_raw(from.z.raw - raw)};
                return hull_contents(level, level.world(), Hull::Point, p);
            };
            std::int32_t open = 0;  // how far it is open, in steps
            while (open < kMost * 4096 && contents_below(open) != contents::kSolid) open += kStep;
            const auto floor = find_floor(level, from, World::from_int(kMost));
            if (!floor) {
                missed += open > 0 && open < kMost * 4096 && contents_below(open - kStep) != contents::kSky;
                continue;
            }
            ++found;
            const std::int32_t depth = from.z.raw - floor->position.z.raw;
            ASSERT_GE(open, depth);
            ASSERT_LE(open, depth + kStep);
            ASSERT_EQ(contents_below(depth + 8), contents::kSolid);
            const PlaneDistance off = plane_distance(level.planes[floor->plane], floor->position);
            ASSERT_LE(absolute(off), PlaneDistance::from_raw(std::int64_t{1} << 32)) << "within 1/1,024 unit";
        }
        EXPECT_GT(found, 50);
        EXPECT_LT(missed, found / 4) << "steep ones";
    }
}

}  // namespace oblong::test
