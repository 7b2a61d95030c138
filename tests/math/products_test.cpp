#include "engine/math/products.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace oblong {
namespace {

using Whole = Fixed<std::int32_t, 0>;

Vec3<Whole> whole(std::int32_t x, std::int32_t y, std::int32_t z) {
    return {Whole::from_int(x), Whole::from_int(y), Whole::from_int(z)};
}

RC_GTEST_PROP(Dot, IsLinearAndSymmetric, (std::int16_t a, std::int16_t b, std::int16_t c, std::int16_t d)) {
    const auto u = whole(a, b, c), v = whole(b, d, a), w = whole(d, c, b);
    RC_ASSERT(dot(u, v) == dot(v, u));
    RC_ASSERT(dot(u, v + w) == dot(u, v) + dot(u, w));
}

RC_GTEST_PROP(Cross, IsAtRightAnglesToBothAndFlipsWithTheirOrder,
              (std::int16_t a, std::int16_t b, std::int16_t c, std::int16_t d, std::int16_t e, std::int16_t f)) {
    const auto u = whole(a, b, c), v = whole(d, e, f);
    const auto normal = cross(u, v);
    const auto along = [&normal](const Vec3<Whole>& w) {
        return normal.x.raw * w.x.raw + normal.y.raw * w.y.raw + normal.z.raw * w.z.raw;
    };
    RC_ASSERT(along(u) == 0);
    RC_ASSERT(along(v) == 0);
    RC_ASSERT(cross(v, u) == -normal);
    // Lagrange: |u x v|^2 = |u|^2 |v|^2 - (u . v)^2, modulo 2^64.
    const auto square = [](std::int64_t n) { return static_cast<std::uint64_t>(n) * static_cast<std::uint64_t>(n); };
    RC_ASSERT(square(normal.x.raw) + square(normal.y.raw) + square(normal.z.raw) ==
              static_cast<std::uint64_t>(dot(u, u).raw) * static_cast<std::uint64_t>(dot(v, v).raw) -
                  square(dot(u, v).raw));
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

}  // namespace
}  // namespace oblong
