#include "engine/math/vec.h"

#include <gtest/gtest.h>

#include "engine/methods/lines.h"
#include "tests/math/vectors.h"

namespace oblong::test {

namespace {

using Whole = Fixed<std::int32_t, 0>;

Vec3<Whole> whole(std::int32_t x, std::int32_t y, std::int32_t z) {
    return {Whole::from_int(x), Whole::from_int(y), Whole::from_int(z)};
}

TEST(DotAndCross, ObeyTheirLaws) {
    std::mt19937 random(3);
    const auto any = [&random] {
        const auto part = [&random] {
            return static_cast<std::int16_t>(static_cast<std::int16_t>(random()) >> random() % 16);
        };
        return whole(part(), part(), part());
    };
    // Modulo 2^64.
    const auto square = [](std::int64_t n) { return static_cast<std::uint64_t>(n) * static_cast<std::uint64_t>(n); };
    for (int i = 0; i < 20'000; ++i) {
        const auto u = any(), v = any(), w = any();
        ASSERT_EQ(dot(u, v), dot(v, u));
        ASSERT_EQ(dot(u, v + w), dot(u, v) + dot(u, w));
        const auto normal = cross(u, v);
        const auto along = [&normal](const Vec3<Whole>& other) {
            return normal.x.raw * other.x.raw + normal.y.raw * other.y.raw + normal.z.raw * other.z.raw;
        };
        ASSERT_EQ(along(u), 0);
        ASSERT_EQ(along(v), 0);
        ASSERT_EQ(cross(v, u), -normal);
        // Lagrange: |u x v|^2 = |u|^2 |v|^2 - (u . v)^2.
        ASSERT_EQ(square(normal.x.raw) + square(normal.y.raw) + square(normal.z.raw),
                  static_cast<std::uint64_t>(dot(u, u).raw) * static_cast<std::uint64_t>(dot(v, v).raw) -
                      square(dot(u, v).raw));
    }
}

TEST(HardCaseV2, DotOfTheFarthestWorldPointWithAUnitVectorFits) {
    const Vec3<World> corner{World::lowest(), World::lowest(), World::lowest()};
    // 1 / sqrt(3), rounded up: the direction in which the corner is farthest.
    const Unit third = Unit::from_raw(619'925'132);
    const Vec3<Unit> diagonal{third, third, third};
    __extension__ using Int128 = __int128;
    const Int128 exact = Int128{3} * std::numeric_limits<std::int32_t>::min() * third.raw;
    EXPECT_TRUE(Int128{dot(corner, diagonal).raw} == exact);
}

void expect_unit_in_direction_of(const std::array<Unit, 3>& unit, const std::array<std::int64_t, 3>& vector) {
    long double squares = 0;
    for (const std::int64_t component : vector)
        squares += static_cast<long double>(component) * static_cast<long double>(component);
    for (std::size_t i = 0; i < 3; ++i) {
        const long double expected = std::ldexp(static_cast<long double>(vector[i]) / std::sqrt(squares), 30);
        ASSERT_LE(std::abs(static_cast<long double>(unit[i].raw) - expected), 0.51L) << vector[i];
    }
}

TEST(Normalised, IsTheNearestUnitVectorOfVectorsOfEveryLength) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 100'000; ++i) {
        const int shift = static_cast<int>(random() % 64);
        std::array<std::int64_t, 3> vector{};
        for (auto& component : vector) component = floor_shift(static_cast<std::int64_t>(random()), shift);
        if (vector == std::array<std::int64_t, 3>{}) continue;
        ASSERT_NO_FATAL_FAILURE(expect_unit_in_direction_of(normalised_raw(vector), vector));
    }
}

TEST(Normalised, EndsOfTheRangeDoNotOverflow) {
    constexpr std::int64_t kLowest = std::numeric_limits<std::int64_t>::min();
    for (const std::array<std::int64_t, 3>& end : {std::array{kLowest, kLowest, kLowest}, {kLowest, 0, 1}, {0, 0, -1}})
        expect_unit_in_direction_of(normalised_raw(end), end);
}

TEST(HardCaseV9, ZeroVectorStaysZeroAndIsNotDividedBy) {
    EXPECT_EQ(normalised(Vec3<Unit>{}), Vec3<Unit>{});
    EXPECT_EQ(normalised_raw(std::array<std::int64_t, 4>{}), (std::array<Unit, 4>{}));
    EXPECT_EQ(length(Vec3<World>{}).raw, 0);
}

TEST(Length, IsTheFlooredRootOfTheSquares) {
    const auto vector = [](std::int32_t x, std::int32_t y, std::int32_t z) {
        return Vec3<World>{World::from_raw(x), World::from_raw(y), World::from_raw(z)};
    };
    EXPECT_EQ(length(vector(2, 3, 6)).raw, 7);
    EXPECT_EQ(length(vector(1, 1, 0)).raw, 1);
    constexpr std::int32_t kLowest = std::numeric_limits<std::int32_t>::min();
    EXPECT_EQ(length(vector(kLowest, kLowest, kLowest)).raw, 3'719'550'786);  // sqrt(3) 2^31 = 3719550786.06
}

TEST(PerpendicularTo, IsAUnitVectorAtRightAnglesToEveryDirection) {
    std::mt19937 random(2);
    for (int i = 0; i < 20'000; ++i) {
        const Vec3<Unit> direction = normalised(any_direction(random));
        const Vec3<Unit> other = perpendicular_to(direction);
        ASSERT_LE(std::abs(dot(direction, other).raw), kOrthonormal60);
        ASSERT_LE(std::abs(dot(other, other).raw - (std::int64_t{1} << 60)), kOrthonormal60);
    }
}

const Plane kFloorAt5 = plane_through(point_at(0, 0, 5), kZ);

TEST(IntersectLine, GoesOnBeyondItsEnds) {
    const auto hit = intersect_line(point_at(0, 0, 7), point_at(0, 4, 6), kFloorAt5);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->world_point, point_at(0, 8, 5));
    EXPECT_EQ(hit->along, (Fixed<std::int64_t, 32>::from_int(2)));
    EXPECT_FALSE(intersect_segment(point_at(0, 0, 7), point_at(0, 4, 6), kFloorAt5)) << "ends before it";
}

/// n . p = d at the answer, as exactly as a point of half a step can satisfy it.
TEST(IntersectSegment, PointLiesInThePlane) {
    std::mt19937 random(1);
    int met = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Plane plane = plane_through(random_world(random), normalised(any_direction(random)));
        const auto hit = intersect_segment(random_world(random), random_world(random), plane);
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
        const Plane plane = plane_through(random_world(random, 2), normalised(any_direction(random)));
        const Vec3<World> origin = random_world(random, 2);
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
    EXPECT_EQ(intersect_ray(point_at(1, 2, 7), -kZ, kFloorAt5), RayDistance::from_int(2));
    EXPECT_EQ(intersect_ray(point_at(1, 2, 7), kZ, kFloorAt5), RayDistance::from_int(-2));
    EXPECT_FALSE(intersect_ray(point_at(1, 2, 7), kX, kFloorAt5));
    EXPECT_EQ(point_on_ray(point_at(1, 2, 7), -kZ, RayDistance::from_int(2)), point_at(1, 2, 5));
    EXPECT_EQ(point_on_ray(point_at(1, 2, 7), kZ, RayDistance::highest()).z, World::highest());
}

}  // namespace

}  // namespace oblong::test
