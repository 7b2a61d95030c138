#include "engine/math/basis.h"

#include <gtest/gtest.h>

#include <numbers>

#include "engine/methods/transforms.h"
#include "tests/math/vectors.h"

namespace oblong::test {
namespace {

using Vector = std::array<long double, 3>;

struct Axes {
    Vector right, up, forward;
};

long double radians_of(Angle angle) {
    return angle.bam * (std::numbers::pi_v<long double> / 32768);
}

/// a cos(angle) + b sin(angle): a turned toward b.
Vector turned(const Vector& a, const Vector& b, long double angle) {
    Vector result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = a[i] * std::cos(angle) + b[i] * std::sin(angle);
    return result;
}

/// One turn after the other, as the conventions tell them: the reference that the closed formulas must equal.
Axes turn_by_turn(Axes axes, long double yaw_to_right, long double pitch_up, long double roll) {
    const Axes start = axes;
    axes.forward = turned(start.forward, start.right, yaw_to_right);
    axes.right = turned(start.right, start.forward, -yaw_to_right);
    const Axes yawed = axes;
    axes.forward = turned(yawed.forward, yawed.up, pitch_up);
    axes.up = turned(yawed.up, yawed.forward, -pitch_up);
    const Axes pitched = axes;
    axes.right = turned(pitched.right, pitched.up, roll);
    axes.up = turned(pitched.up, pitched.right, -roll);
    return axes;
}

void expect_near(const Basis& got, const Axes& expected) {
    for (const auto& [axis, exact] :
         {std::pair{got.right, expected.right}, {got.up, expected.up}, {got.forward, expected.forward}}) {
        const std::array parts{axis.x, axis.y, axis.z};
        for (std::size_t i = 0; i < 3; ++i) ASSERT_LE(std::abs(parts[i].raw - std::ldexp(exact[i], 30)), 0.51);
    }
}

TEST(Basis, EqualsOneTurnAfterTheOther) {
    const Axes quake{{0, -1, 0}, {0, 0, 1}, {1, 0, 0}};
    const Axes y_up{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        // First all quarter turns, which are exact.
        const auto any = [&](int shift) {
            return i < 64 ? Angle::from_bam((i >> shift) * 16384) : random_angle(random);
        };
        const Angle yaw = any(0), pitch = any(2), roll = any(4);
        const long double y = radians_of(yaw), p = radians_of(pitch), r = radians_of(roll);
        // Quake's angles run the other way: counter-clockwise yaw turns left, pitch down, roll sinks the right side.
        ASSERT_NO_FATAL_FAILURE(expect_near(view_basis(yaw, pitch, roll), turn_by_turn(quake, -y, -p, -r)));
        ASSERT_NO_FATAL_FAILURE(expect_near(y_up_basis(yaw, pitch, roll), turn_by_turn(y_up, y, p, r)));
    }
}

TEST(HardCaseT3, WholeTurnsChangeNoBit) {
    const Basis once = view_basis(Angle::from_bam(1234), Angle::from_bam(-777), Angle::from_bam(31));
    const Basis many = view_basis(Angle::from_bam(1234 + 65536 * 1'000'000LL), Angle::from_bam(-777 - 65536 * 99LL),
                                  Angle::from_bam(31 + 65536));
    EXPECT_EQ(once, many);
}

TEST(ToView, IsTheExactDotProductRoundedOnce) {
    __extension__ using Int128 = __int128;
    std::mt19937_64 random(2);
    for (int i = 0; i < 20'000; ++i) {
        const Basis basis = random_axes(random);
        const Vec3<World> point = random_world(random), eye = random_world(random);
        const auto exact = [&](const Vec3<Unit>& axis) {
            const Int128 sum = Int128{axis.x.raw} * (Int128{point.x.raw} - eye.x.raw) +
                               Int128{axis.y.raw} * (Int128{point.y.raw} - eye.y.raw) +
                               Int128{axis.z.raw} * (Int128{point.z.raw} - eye.z.raw) + (1 << 25);
            return View::from_raw(static_cast<std::int64_t>(sum >> 26));
        };
        ASSERT_EQ(to_view(point, eye, basis), (Vec3<View>{exact(basis.right), exact(basis.up), exact(basis.forward)}));
    }
}

/// A target in the direction of a yaw and a pitch gives the basis of that yaw and pitch.
TEST(LookAt, EqualsTheBasisOfItsAngles) {
    std::mt19937 random(1);
    for (int i = 0; i < 5'000; ++i) {
        const Angle yaw = random_angle(random), pitch = Angle::from_bam(random_below(random, 30'000) - 15'000);
        const Basis expected = view_basis(yaw, pitch, {});
        const auto step = [](Unit component) { return World::from_raw(component.raw); };
        const Vec3<World> target{step(expected.forward.x), step(expected.forward.y), step(expected.forward.z)};
        const Basis got = look_at({}, target, kZ);
        // The nearer to straight up, the less a step of the target says about yaw: 1 / cos(80 degrees) steps.
        for (const auto& [a, b] :
             {std::pair{got.right, expected.right}, {got.up, expected.up}, {got.forward, expected.forward}})
            for (const Unit off : {a.x - b.x, a.y - b.y, a.z - b.z}) ASSERT_LE(std::abs(off.raw), 12);
    }
}

TEST(HardCaseT4, EyeInItsTargetLooksLevel) {
    const Basis basis = look_at(point_at(7, 8, 9), point_at(7, 8, 9), kZ);
    EXPECT_LE(worst_flaw_60(basis), kOrthonormal60);
    EXPECT_EQ(basis.forward.z, Unit{});
    EXPECT_EQ(basis.up, kZ);
}

TEST(HardCaseT4, StraightUpAndDownAreDefined) {
    for (const std::int32_t z : {1, -1, 30'000, -30'000}) {
        const Basis basis = look_at(point_at(0, 0, 0), point_at(0, 0, z), kZ);
        EXPECT_LE(worst_flaw_60(basis), kOrthonormal60);
        EXPECT_EQ(basis.forward, z > 0 ? kZ : -kZ);
    }
    EXPECT_LE(worst_flaw_60(look_at(point_at(0, 0, 0), point_at(1, 2, 3), {})), kOrthonormal60) << "no hint";
    EXPECT_LE(worst_flaw_60(look_at(point_at(0, 0, 0), point_at(0, 0, 0), {})), kOrthonormal60)
        << "no hint and no target";
}

TEST(HardCaseT4, PitchOf90DegreesIsABasis) {
    for (const Angle pitch : {kQuarterTurn, -kQuarterTurn})
        for (int yaw = 0; yaw < 65536; yaw += 101)
            ASSERT_LE(worst_flaw_60(view_basis(Angle::from_bam(yaw), pitch, {})), kOrthonormal60);
}

TEST(LookAt, IsOrthonormalForAnyThreePoints) {
    std::mt19937 random(2);
    for (int i = 0; i < 20'000; ++i) {
        const auto any = [&random] {
            return World::from_raw(floor_shift(static_cast<std::int32_t>(random()), static_cast<int>(random() % 32)));
        };
        const Vec3<World> eye{any(), any(), any()}, target{any(), any(), any()};
        ASSERT_LE(worst_flaw_60(look_at(eye, target, any_direction(random))), kOrthonormal60);
    }
}

TEST(OrthonormalFlaw, IsTheLargestOfLengthsAndAngles) {
    const Unit half = fixed_of<Unit>(0.5);
    EXPECT_EQ(orthonormal_flaw({kX, kY, kZ}), Sine60{});
    EXPECT_EQ(orthonormal_flaw({kX, kY, {{}, {}, half}}).raw, std::int64_t{3} << 58) << "1/4 for 1";
    EXPECT_EQ(orthonormal_flaw({kX, {half, Unit::from_int(1), {}}, kZ}).raw, std::int64_t{1} << 59) << "1/2 for 0";
    EXPECT_EQ(orthonormal_flaw({kX, {}, kZ}).raw, std::int64_t{1} << 60) << "0 for 1";
    EXPECT_TRUE(is_orthonormal({kX, -kZ, kY}));
    EXPECT_FALSE(is_orthonormal({kX, kX, kZ}));
}

TEST(OrthonormalFlaw, EveryBasisMadeOfAnglesIsOrthonormal) {
    std::mt19937 random(5);
    for (int i = 0; i < 20'000; ++i) {
        const Basis basis = random_axes(random);
        ASSERT_EQ(orthonormal_flaw(basis).raw, worst_flaw_60(basis));
        ASSERT_TRUE(is_orthonormal(basis));
    }
}

TEST(Orthonormalised, MendsAnyAxesAndKeepsTheirHandedness) {
    std::mt19937 random(3);
    for (int i = 0; i < 20'000; ++i) {
        const Basis crooked{any_direction(random), any_direction(random), any_direction(random)};
        const Basis mended = orthonormalised(crooked);
        ASSERT_LE(worst_flaw_60(mended), kOrthonormal60);
        ASSERT_GE(dot(mended.right, crooked.right).raw, 0);
    }
    for (const Basis& basis : {view_basis({}, {}, {}), y_up_basis({}, {}, {})})
        EXPECT_EQ(orthonormalised(basis), basis);
}

TEST(Orthonormalised, AxesWithoutADirectionAreReplaced) {
    EXPECT_LE(worst_flaw_60(orthonormalised({})), kOrthonormal60);
    EXPECT_LE(worst_flaw_60(orthonormalised({kX, kX, kX})), kOrthonormal60);
    EXPECT_EQ(orthonormalised({kX, kX, kX}).forward, kX);
}

}  // namespace
}  // namespace oblong::test
