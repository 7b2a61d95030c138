#include <gtest/gtest.h>

#include "engine/fixed/trig.h"
#include "engine/math/basis.h"
#include "tests/math/vectors.h"

namespace oblong {
namespace {

constexpr auto kOne = Unit::from_int(1);
constexpr Vec3<Unit> kX{kOne, {}, {}}, kY{{}, kOne, {}}, kZ{{}, {}, kOne};

Vec3<World> at(std::int32_t x, std::int32_t y, std::int32_t z) {
    return {World::from_int(x), World::from_int(y), World::from_int(z)};
}

TEST(LookAt, AlongTheWorldsAxes) {
    EXPECT_EQ(look_at(at(0, 0, 0), at(5, 0, 0), kZ), view_basis({}, {}, {}));
    EXPECT_EQ(look_at(at(0, 0, 0), at(0, 5, 0), kZ), view_basis(kQuarterTurn, {}, {}));
    EXPECT_EQ(look_at(at(0, 0, 0), at(0, 0, 5), kY, Handedness::Left), y_up_basis({}, {}, {}));
}

/// A target in the direction of a yaw and a pitch gives the basis of that yaw and pitch.
TEST(LookAt, EqualsTheBasisOfItsAngles) {
    std::mt19937 random(1);
    for (int i = 0; i < 5'000; ++i) {
        const Angle yaw = Angle::from_bam(random()),
                    pitch = Angle::from_bam(static_cast<int>(random() % 30'000) - 15'000);
        const Basis expected = view_basis(yaw, pitch, {});
        const auto step = [](Unit component) { return World::from_raw(component.raw); };
        const Vec3<World> target{step(expected.forward.x), step(expected.forward.y), step(expected.forward.z)};
        const Basis got = look_at({}, target, kZ);
        for (const auto& [a, b] :
             {std::pair{got.right, expected.right}, {got.up, expected.up}, {got.forward, expected.forward}}) {
            // The nearer to straight up, the less a step of the target says about yaw: 1 / cos(80 degrees) steps.
            ASSERT_LE(std::abs(a.x.raw - b.x.raw), 12);
            ASSERT_LE(std::abs(a.y.raw - b.y.raw), 12);
            ASSERT_LE(std::abs(a.z.raw - b.z.raw), 12);
        }
    }
}

TEST(HardCaseT4, EyeInItsTargetLooksLevel) {
    const Basis basis = look_at(at(7, 8, 9), at(7, 8, 9), kZ);
    EXPECT_LE(worst_flaw_60(basis), kOrthonormal60);
    EXPECT_EQ(basis.forward.z, Unit{});
    EXPECT_EQ(basis.up, kZ);
}

TEST(HardCaseT4, StraightUpAndDownAreDefined) {
    for (const std::int32_t z : {1, -1, 30'000, -30'000}) {
        const Basis basis = look_at(at(0, 0, 0), at(0, 0, z), kZ);
        EXPECT_LE(worst_flaw_60(basis), kOrthonormal60);
        EXPECT_EQ(basis.forward, z > 0 ? kZ : -kZ);
    }
    EXPECT_LE(worst_flaw_60(look_at(at(0, 0, 0), at(1, 2, 3), {})), kOrthonormal60) << "no hint";
    EXPECT_LE(worst_flaw_60(look_at(at(0, 0, 0), at(0, 0, 0), {})), kOrthonormal60) << "no hint and no target";
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

}  // namespace
}  // namespace oblong
