
#include <gtest/gtest.h>

#include <random>

#include "engine/fixed/trig.h"
#include "engine/math/rotation.h"
#include "engine/math/vec.h"
#include "tests/math/vectors.h"

namespace oblong {
namespace {

constexpr std::int64_t kOne60 = std::int64_t{1} << 60;
constexpr Vec3<Unit> kZ{{}, {}, Unit::from_int(1)};

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

}  // namespace
}  // namespace oblong
