#include <gtest/gtest.h>

#include <numbers>

#include "engine/methods/transforms.h"
#include "tests/math/vectors.h"

namespace oblong::test {
namespace {

using Real = long double;
using Real3 = std::array<std::array<Real, 3>, 3>;

Real number(Entry value) {
    return std::ldexp(static_cast<Real>(value.raw), -32);
}

Real radians(Angle angle) {
    return static_cast<Real>(angle.bam) / 32768 * std::numbers::pi_v<Real>;
}

Real3 product(const Real3& a, const Real3& b) {
    Real3 result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
    return result;
}

/// The course notes' matrix for a rotation about z, with the axes counted on for x and y.
Real3 about(std::size_t axis, Angle angle) {
    const Real sine = std::sin(radians(angle)), cosine = std::cos(radians(angle));
    const std::size_t first = (axis + 1) % 3, second = (axis + 2) % 3;
    Real3 result{};
    result[axis][axis] = 1;
    result[first][first] = result[second][second] = cosine;
    result[first][second] = -sine;
    result[second][first] = sine;
    return result;
}

void expect_matrix(const Matrix3& got, const Real3& expected, Real tolerance) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            ASSERT_LE(std::abs(number(got.rows[i][j]) - expected[i][j]), tolerance) << i << " " << j;
}

EulerAngles any_angles(std::mt19937& random) {
    const Angle yaw = random_angle(random), pitch = random_angle(random);
    return {yaw, pitch, random_angle(random)};
}
/// Roll, then pitch, then yaw.
Real3 product_of(const EulerAngles& angles) {
    return product(about(2, angles.yaw), product(about(1, angles.pitch), about(0, angles.roll)));
}

constexpr Real kStep = 0x1p-30L;

TEST(RotationMatrix, AboutEachAxisIsTheCourseNotesMatrix) {
    const std::array axes{kX, kY, kZ};
    std::mt19937 random(1);
    for (int i = 0; i < 2'000; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Angle angle = random_angle(random);
            ASSERT_NO_FATAL_FAILURE(expect_matrix(rotation_matrix(axes[axis], angle), about(axis, angle), kStep));
        }
}

TEST(RotationMatrix, EulerAnglesAreRollThenPitchThenYaw) {
    std::mt19937 random(2);
    for (int i = 0; i < 2'000; ++i) {
        const EulerAngles angles = any_angles(random);
        ASSERT_NO_FATAL_FAILURE(expect_matrix(rotation_matrix(angles), product_of(angles), kStep));
    }
}

TEST(RotationMatrix, QuaternionOfEulerAnglesTurnsAsTheyDo) {
    std::mt19937 random(3);
    for (int i = 0; i < 2'000; ++i) {
        const EulerAngles angles = any_angles(random);
        const Matrix3 by_angles = rotation_matrix(angles), by_quaternion = rotation_matrix(quaternion_of(angles));
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                ASSERT_LE(std::abs(by_angles.rows[row][column].raw - by_quaternion.rows[row][column].raw), 10 * 4);
    }
}

TEST(ModelMatrix, IsTheProductOfItsThreeMatrices) {
    std::mt19937 random(6);
    for (int i = 0; i < 2'000; ++i) {
        const Vec3<World> at = random_world(random, i % 32);
        const auto any_scale = [&random] {
            return Entry::from_raw(static_cast<std::int64_t>(random()) << (random() % 28));
        };
        const Vec3<Entry> scale{any_scale(), any_scale(), any_scale()};
        const Matrix3 rotation = rotation_matrix(any_angles(random));
        ASSERT_EQ(model_matrix(at, rotation, scale),
                  translation(convert<Entry>(at)) * homogeneous(rotation) * scaling(scale));
    }
}

TEST(ModelMatrix, PointsAreRoundedOnceAndSaturate) {
    std::mt19937 random(4);
    for (int i = 0; i < 2'000; ++i) {
        const EulerAngles angles = any_angles(random);
        const Vec3<World> at = random_world(random, 6), p = random_world(random, 6);
        const Vec3<World> got = transformed_point(
            model_matrix(at, angles, {Entry::from_int(1), Entry::from_int(1), Entry::from_int(1)}), p);
        const Real3 turn = product_of(angles);
        const Real x = turn[0][0] * p.x.raw + turn[0][1] * p.y.raw + turn[0][2] * p.z.raw + at.x.raw;
        // Entries are off by half a step of 2^-30, coordinates have at most 25 bits.
        ASSERT_LE(std::abs(x - got.x.raw), 0.5L + 3 * 0x1p-31L * 0x1p25L);
    }
    const Matrix4 huge = scaling({Entry::from_int(1 << 29), Entry::from_int(-(1 << 29)), Entry::from_int(1)});
    const World far = World::from_int(1000);
    EXPECT_EQ(transformed_point(huge, {far, far, far}), (Vec3<World>{World::highest(), World::lowest(), far}));
}

TEST(TransformedNormal, StaysAtRightAnglesToAStretchedSurface) {
    std::mt19937 random(5);
    for (int i = 0; i < 2'000; ++i) {
        const EulerAngles angles = any_angles(random);
        const auto any_scale = [&random] { return Entry::from_raw((std::int64_t{1} << 30) + random()); };
        const Matrix4 model = model_matrix({}, angles, {any_scale(), any_scale(), any_scale()});
        const Vec3<Unit> normal = normalised(any_direction(random));
        const Vec3<Unit> along = perpendicular_to(normal);
        const Vec3<Unit> turned = normalised(*normal_matrix(linear_part(model)) * convert<Entry>(normal));
        const Vec3<Unit> surface = normalised(linear_part(model) * convert<Entry>(along));
        ASSERT_LE(std::abs(dot(turned, surface).raw), kOrthonormal60);
    }
}

}  // namespace
}  // namespace oblong::test
