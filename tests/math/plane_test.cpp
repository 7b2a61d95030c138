#include "engine/math/plane.h"

#include <gtest/gtest.h>

#include "engine/math/vec.h"
#include "engine/methods/line_and_plane.h"
#include "tests/math/vectors.h"

namespace oblong {
namespace {

constexpr Vec3<Unit> kZ{{}, {}, Unit::from_int(1)};

Vec3<World> at(std::int32_t x, std::int32_t y, std::int32_t z) {
    return {World::from_int(x), World::from_int(y), World::from_int(z)};
}

const Plane kFloorAt5 = plane_through(at(0, 0, 5), kZ);

TEST(DistanceToPlane, IsPositiveInFront) {
    EXPECT_EQ(distance_to_plane(at(1, 2, 10), kFloorAt5), PlaneDistance::from_int(5));
    EXPECT_EQ(distance_to_plane(at(1, 2, -10), kFloorAt5), PlaneDistance::from_int(-15));
    EXPECT_EQ(distance_to_plane(at(1, 2, 5), kFloorAt5), PlaneDistance{});
}

TEST(IntersectLine, GoesOnBeyondItsEnds) {
    const auto hit = intersect_line(at(0, 0, 7), at(0, 4, 6), kFloorAt5);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->world_point, at(0, 8, 5));
    EXPECT_EQ(hit->along, (Fixed<std::int64_t, 32>::from_int(2)));
    EXPECT_FALSE(intersect_segment(at(0, 0, 7), at(0, 4, 6), kFloorAt5)) << "ends before it";
}

TEST(IntersectSegment, EndsInThePlaneCountAsMet) {
    const auto met = [](const Vec3<World>& start, const Vec3<World>& end) {
        const auto hit = intersect_segment(start, end, kFloorAt5);
        return hit && hit->world_point == at(3, 3, 5);
    };
    for (const Vec3<World>& other : {at(0, 0, 9), at(0, 0, 1)}) {
        EXPECT_TRUE(met(other, at(3, 3, 5)));
        EXPECT_TRUE(met(at(3, 3, 5), other));
    }
    EXPECT_TRUE(met(at(3, 3, 5), at(0, 0, 5))) << "lies in it";
}

/// n . p = d at the answer, as exactly as a point of half a step can satisfy it.
TEST(IntersectSegment, PointLiesInThePlane) {
    std::mt19937 random(1);
    int met = 0;
    for (int i = 0; i < 50'000; ++i) {
        const auto any = [&random] { return World::from_raw(static_cast<std::int32_t>(random())); };
        const Plane plane = plane_through({any(), any(), any()}, normalised(any_direction(random)));
        const auto hit = intersect_segment({any(), any(), any()}, {any(), any(), any()}, plane);
        if (!hit || plane.normal == Vec3<Unit>{}) continue;
        ++met;
        // Half a step of 2^-12 in each of three coordinates: at most sqrt(3) / 2 steps along the normal.
        ASSERT_LE(std::abs(distance_to_plane(hit->world_point, plane).raw), (std::int64_t{1} << 30) * 87 / 100);
        ASSERT_GE(hit->along.raw, 0);
        ASSERT_LE(hit->along.raw, std::int64_t{1} << 32);
    }
    EXPECT_GT(met, 5'000);
}

/// The seed's quotient of dot products, in double.
TEST(IntersectRay, IsTheDistanceInFrontOverTheApproach) {
    std::mt19937 random(2);
    for (int i = 0; i < 20'000; ++i) {
        const auto any = [&random] { return World::from_raw(static_cast<std::int32_t>(random()) / 4); };
        const Plane plane = plane_through({any(), any(), any()}, normalised(any_direction(random)));
        const Vec3<World> origin{any(), any(), any()};
        const Vec3<Unit> direction = normalised(any_direction(random));
        const long double above = std::ldexp(static_cast<long double>(distance_to_plane(origin, plane).raw), -42);
        const long double approach = -std::ldexp(static_cast<long double>(dot(direction, plane.normal).raw), -60);
        const auto found = intersect_ray(origin, direction, plane);
        ASSERT_EQ(found.has_value(), approach != 0);
        if (!found || std::abs(above / approach) > 1e11L) continue;
        ASSERT_LE(std::abs(static_cast<long double>(found->raw) - std::ldexp(above / approach, 24)), 1) << i;
    }
}

TEST(IntersectRay, IsBelow0BehindTheOriginAndNoneForAParallelRay) {
    const Vec3<Unit> up{{}, {}, Unit::from_int(1)}, along{Unit::from_int(1), {}, {}};
    EXPECT_EQ(intersect_ray(at(1, 2, 7), -up, kFloorAt5), RayDistance::from_int(2));
    EXPECT_EQ(intersect_ray(at(1, 2, 7), up, kFloorAt5), RayDistance::from_int(-2));
    EXPECT_FALSE(intersect_ray(at(1, 2, 7), along, kFloorAt5));
    EXPECT_EQ(point_on_ray(at(1, 2, 7), -up, RayDistance::from_int(2)), at(1, 2, 5));
    EXPECT_EQ(point_on_ray(at(1, 2, 7), up, RayDistance::highest()).z, World::highest());
}

}  // namespace
}  // namespace oblong
