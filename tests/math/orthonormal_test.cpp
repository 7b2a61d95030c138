#include <gtest/gtest.h>

#include "engine/math/basis.h"
#include "engine/math/rotation.h"
#include "engine/math/vec.h"
#include "tests/math/vectors.h"

namespace oblong {
namespace {

constexpr Vec3<Unit> kX{Unit::from_int(1), {}, {}}, kY{{}, Unit::from_int(1), {}}, kZ{{}, {}, Unit::from_int(1)};

TEST(OrthonormalFlaw, IsTheLargestOfLengthsAndAngles) {
    const Unit half = Unit::from_raw(1 << 29);
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
        const Basis basis = view_basis(Angle::from_bam(random()), Angle::from_bam(random()), Angle::from_bam(random()));
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

TEST(HardCaseT2, RotationsOneAfterTheOtherStayOrthonormal) {
    Basis basis = view_basis({}, {}, {});
    const Vec3<Unit> axis = normalised(Vec3<Unit>{Unit::from_raw(3), Unit::from_raw(-5), Unit::from_raw(7)});
    for (int i = 0; i < 100'000; ++i) {
        basis = orthonormalised(rotate_about_axis(basis, axis, Angle::from_bam(182)));
        ASSERT_LE(worst_flaw_60(basis), kOrthonormal60) << i;
    }
}

}  // namespace
}  // namespace oblong
