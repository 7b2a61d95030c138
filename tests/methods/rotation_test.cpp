#include <gtest/gtest.h>

#include <numbers>

#include "engine/methods/transforms.h"
#include "tests/math/vectors.h"

namespace oblong::test {
namespace {

/// A direction as numbers of 64 bits' precision.
std::array<long double, 3> exact(const Vec3<Unit>& v) {
    const auto value = [](Unit component) { return std::ldexp(static_cast<long double>(component.raw), -30); };
    return {value(v.x), value(v.y), value(v.z)};
}

void expect_near(const Vec3<Unit>& got, const Vec3<Unit>& expected, int steps) {
    const Vec3<Unit> off = got - expected;
    ASSERT_LE(std::max({std::abs(off.x.raw), std::abs(off.y.raw), std::abs(off.z.raw)}), steps);
}

/// Rodrigues in 64-bit mantissas.
TEST(RotateAboutAxis, IsWithinAStepOfTheFormula) {
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        const Vec3<Unit> axis = normalised(any_direction(random)), v = normalised(any_direction(random));
        if (axis == Vec3<Unit>{} || v == Vec3<Unit>{}) continue;
        const Angle angle = random_angle(random);
        const long double c = std::cos(angle.bam * std::numbers::pi_v<long double> / 32768);
        const long double s = std::sin(angle.bam * std::numbers::pi_v<long double> / 32768);
        const auto a = exact(axis), b = exact(v), got = exact(rotate_about_axis(v, axis, angle));
        const long double along = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        for (std::size_t k = 0; k < 3; ++k) {
            const long double crossed = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
            ASSERT_LE(std::abs(got[k] - (b[k] * c + crossed * s + a[k] * along * (1 - c))), 0x1.1p-31L);
        }
    }
}

TEST(ProjectOntoAxes, IsUndoneBySummingAlongThem) {
    std::mt19937 random(2);
    for (int i = 0; i < 20'000; ++i) {
        const Basis basis = random_axes(random);
        const Vec3<Unit> v = normalised(any_direction(random));
        ASSERT_NO_FATAL_FAILURE(expect_near(sum_along_axes(project_onto_axes(v, basis), basis), v, 4));
    }
}

constexpr std::int64_t kOne60 = std::int64_t{1} << 60;

std::int64_t dot_60(const Quaternion& a, const Quaternion& b) {
    return std::int64_t{a.w.raw} * b.w.raw + std::int64_t{a.x.raw} * b.x.raw + std::int64_t{a.y.raw} * b.y.raw +
           std::int64_t{a.z.raw} * b.z.raw;
}

Quaternion any_rotation(std::mt19937& random) {
    return quaternion_about_axis(normalised(any_direction(random)), random_angle(random));
}

TEST(Quaternion, RotatesAsRodriguesFormulaDoes) {
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        const Vec3<Unit> axis = normalised(any_direction(random)), v = normalised(any_direction(random));
        const Angle angle = random_angle(random);
        ASSERT_NO_FATAL_FAILURE(
            expect_near(rotate(v, quaternion_about_axis(axis, angle)), rotate_about_axis(v, axis, angle), 4));
    }
}

TEST(Quaternion, ProductIsOneRotationAfterTheOther) {
    std::mt19937 random(2);
    for (int i = 0; i < 20'000; ++i) {
        const Quaternion a = any_rotation(random), b = any_rotation(random);
        const Vec3<Unit> v = normalised(any_direction(random));
        // Half a step in each of a quaternion's components turns and stretches by up to four steps.
        ASSERT_NO_FATAL_FAILURE(expect_near(rotate(v, a * b), rotate(rotate(v, b), a), 16));
        ASSERT_NO_FATAL_FAILURE(expect_near(rotate(rotate(v, a), Quaternion{a.w, -a.x, -a.y, -a.z}), v, 16));
    }
}

TEST(Quaternion, NormalisedHasLengthOneAndZeroStaysZero) {
    const Quaternion long_one{Unit::from_raw(5), Unit::from_raw(-5), Unit::from_raw(5), Unit::from_raw(5)};
    EXPECT_LE(std::abs(dot_60(normalised(long_one), normalised(long_one)) - kOne60), std::int64_t{1} << 31);
    const Quaternion zero{Unit{}, {}, {}, {}};
    EXPECT_EQ(normalised(zero), zero);
}

}  // namespace
}  // namespace oblong::test
