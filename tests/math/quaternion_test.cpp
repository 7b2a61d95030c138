#include "engine/math/quaternion.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "engine/fixed/trig.h"
#include "engine/math/vec.h"
#include "engine/math/rotation.h"
#include "tests/math/vectors.h"

namespace oblong {
namespace {

constexpr std::int64_t kOne60 = std::int64_t{1} << 60;
constexpr Vec3<Unit> kX{Unit::from_int(1), {}, {}}, kZ{{}, {}, Unit::from_int(1)};

std::int64_t dot_60(const Quaternion& a, const Quaternion& b) {
    return std::int64_t{a.w.raw} * b.w.raw + std::int64_t{a.x.raw} * b.x.raw + std::int64_t{a.y.raw} * b.y.raw +
           std::int64_t{a.z.raw} * b.z.raw;
}

Quaternion any_rotation(std::mt19937& random) {
    return quaternion_about_axis(normalised(any_direction(random)), Angle::from_bam(random()));
}

void expect_near(const Vec3<Unit>& got, const Vec3<Unit>& expected, int steps) {
    ASSERT_LE(std::abs(got.x.raw - expected.x.raw), steps);
    ASSERT_LE(std::abs(got.y.raw - expected.y.raw), steps);
    ASSERT_LE(std::abs(got.z.raw - expected.z.raw), steps);
}

/// The angle between two rotations seen as points of the sphere, 0 to pi.
long double arc(const Quaternion& a, const Quaternion& b) {
    const auto value = [](Unit c) { return static_cast<long double>(c.raw); };
    const long double across = std::hypot(value(a.w) - value(b.w), value(a.x) - value(b.x)),
                      apart = std::hypot(across, value(a.y) - value(b.y), value(a.z) - value(b.z));
    return 2 * std::asin(std::min(1.0L, apart / 0x1p31L));
}

TEST(Quaternion, RotatesAsRodriguesFormulaDoes) {
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        const Vec3<Unit> axis = normalised(any_direction(random)), v = normalised(any_direction(random));
        const Angle angle = Angle::from_bam(random());
        expect_near(rotate(v, quaternion_about_axis(axis, angle)), rotate_about_axis(v, axis, angle), 4);
        if (HasFatalFailure()) return;
    }
}

TEST(Quaternion, ProductIsOneRotationAfterTheOther) {
    std::mt19937 random(2);
    for (int i = 0; i < 20'000; ++i) {
        const Quaternion a = any_rotation(random), b = any_rotation(random);
        const Vec3<Unit> v = normalised(any_direction(random));
        // Half a step in each of a quaternion's components turns and stretches by up to four steps.
        expect_near(rotate(v, a * b), rotate(rotate(v, b), a), 16);
        expect_near(rotate(rotate(v, a), a.conjugate()), v, 16);
        if (HasFatalFailure()) return;
    }
}

TEST(Quaternion, TurnsABasisAsAnglesDo) {
    const Basis turned = rotate(view_basis({}, {}, {}), quaternion_about_axis(kZ, Angle::from_bam(7'777)));
    const Basis yawed = view_basis(Angle::from_bam(7'777), {}, {});
    expect_near(turned.forward, yawed.forward, 2);
    expect_near(turned.right, yawed.right, 2);
}

TEST(Quaternion, NormalisedHasLengthOneAndZeroStaysZero) {
    const Quaternion long_one{Unit::from_raw(5), Unit::from_raw(-5), Unit::from_raw(5), Unit::from_raw(5)};
    EXPECT_LE(std::abs(dot_60(normalised(long_one), normalised(long_one)) - kOne60), std::int64_t{1} << 31);
    const Quaternion zero{Unit{}, {}, {}, {}};
    EXPECT_EQ(normalised(zero), zero);
}

TEST(HardCaseT5, SlerpHasLengthOneAndKeepsToTheShorterArc) {
    std::mt19937 random(3);
    for (int i = 0; i < 50'000; ++i) {
        const Quaternion a = any_rotation(random), b = any_rotation(random);
        const Unit t = Unit::from_raw(static_cast<std::int32_t>(random() >> 2));
        const Quaternion between = slerp(a, b, t);
        ASSERT_LE(std::abs(dot_60(between, between) - kOne60), kOne60 >> 28);
        const Quaternion near_b = dot_60(a, b) < 0 ? -b : b;
        const long double whole = arc(a, near_b), part = std::ldexp(static_cast<long double>(t.raw), -30) * whole;
        ASSERT_LE(whole, std::numbers::pi_v<long double> / 2 + 0x1p-28L);
        ASSERT_LE(std::abs(arc(a, between) - part), 0x1p-25L) << i;
        ASSERT_LE(std::abs(arc(between, near_b) - (whole - part)), 0x1p-25L) << i;
    }
}

TEST(HardCaseT5, SlerpEndsAreBitForBitTheRotationsGiven) {
    std::mt19937 random(4);
    for (int i = 0; i < 1'000; ++i) {
        const Quaternion a = any_rotation(random), b = any_rotation(random);
        for (const Quaternion& end : {b, -b, a, -a}) {
            ASSERT_EQ(slerp(a, end, Unit{}), a);
            ASSERT_EQ(slerp(a, end, Unit::from_int(1)), end);
        }
    }
}

TEST(HardCaseT5, SlerpOfEqualAndOppositeRotationsStaysThere) {
    std::mt19937 random(5);
    for (int i = 0; i < 1'000; ++i) {
        const Quaternion a = any_rotation(random);
        for (const Quaternion& same : {a, -a}) {
            const Quaternion between = slerp(a, same, Unit::from_raw(1 << 29));
            ASSERT_LE(arc(a, between), 0x1p-28L);
        }
    }
}

/// On both sides of the limit 1 - |dot| = 2^-16, about 0.316 degrees between the quaternions.
TEST(HardCaseT5, StraightAndCurvedArcsAgreeAtTheirBorder) {
    for (int bam = 100; bam <= 130; ++bam) {
        const Quaternion a = quaternion_about_axis(kX, Angle{}), b = quaternion_about_axis(kX, Angle::from_bam(bam));
        for (int quarter = 1; quarter < 4; ++quarter) {
            const long double expected = arc(a, b) * quarter / 4;
            // b's opposite is the same rotation, and its dot product with a is near -1.
            for (const Quaternion& end : {b, -b}) {
                const Quaternion between = slerp(a, end, Unit::from_raw(quarter << 28));
                ASSERT_LE(std::abs(arc(a, between) - expected), 0x1p-24L) << bam << " " << quarter;
                ASSERT_LE(std::abs(dot_60(between, between) - kOne60), kOne60 >> 24);
            }
        }
    }
}

}  // namespace
}  // namespace oblong
