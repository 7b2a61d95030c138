#include <gtest/gtest.h>

#include "engine/fixed/trig.h"
#include "engine/math/basis.h"
#include "engine/math/vec.h"
#include "engine/methods/transforms.h"
#include "tests/math/vectors.h"

namespace oblong::test {
namespace {

/// The worst flaw of a basis that turns `count` times by one degree about an axis.
std::int64_t worst_flaw_of_turns(const Vec3<Unit>& axis, int count) {
    const Angle degree = degrees_to_angle(Degrees::from_int(1));
    Basis basis = view_basis({}, {}, {});
    std::int64_t worst = 0;
    for (int i = 0; i < count; ++i) {
        basis = orthonormalised(rotate_about_axis(basis, axis, degree));
        worst = std::max(worst, worst_flaw_60(basis));
    }
    return worst;
}

TEST(HardCaseT2, TenMillionRotationsStayOrthonormal) {
    constexpr int kTurns = 10'000'000;
    EXPECT_LE(worst_flaw_of_turns({{}, {}, Unit::from_int(1)}, kTurns), kOrthonormal60);
    const Vec3<Unit> oblique = normalised(Vec3<Unit>{Unit::from_raw(3), Unit::from_raw(-5), Unit::from_raw(7)});
    EXPECT_LE(worst_flaw_of_turns(oblique, kTurns), kOrthonormal60);
}

}  // namespace
}  // namespace oblong::test
