#include "engine/level/bsp_floats.h"

#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>
#include <random>

namespace oblong::test::bsp_floats_test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

using Axis = std::array<float, 4>;
using Place = std::array<float, 3>;

FloatBits bits_of(float value) {
    return FloatBits{std::bit_cast<std::uint32_t>(value)};
}
FloatBits3 bits_of(const Place& p) {
    return {bits_of(p[0]), bits_of(p[1]), bits_of(p[2])};
}
std::array<FloatBits, 4> bits_of(const Axis& axis) {
    return {bits_of(axis[0]), bits_of(axis[1]), bits_of(axis[2]), bits_of(axis[3])};
}

TEST(BspFloats, FixedIsRoundedToNearestTiesUp) {
    EXPECT_EQ(to_fixed(bits_of(1.75F), 0, 100), 2);
    EXPECT_EQ(to_fixed(bits_of(-1.75F), 0, 100), -2);
    EXPECT_EQ(to_fixed(bits_of(2.5F), 0, 100), 3);
    EXPECT_EQ(to_fixed(bits_of(-2.5F), 0, 100), -2);
    EXPECT_EQ(to_fixed(bits_of(0.49999997F), 0, 100), 0);
    EXPECT_EQ(to_fixed(bits_of(0x1.8p-13F), 12, 100), 1);
    EXPECT_EQ(to_fixed(bits_of(-0.F), 12, 100), 0);
}

TEST(BspFloats, LimitIsExclusiveAndNothingElsePasses) {
    EXPECT_EQ(to_fixed(bits_of(99.99F), 0, 100), 100);
    for (const float bad : {100.F, -100.F, 3e38F, kInfinity, -kInfinity, kNan})
        EXPECT_FALSE(to_fixed(bits_of(bad), 0, 100).has_value()) << bad;
}

// Every float from 2^-37 on ends before the 2^-60th: then fixed and rest together are the float itself.
TEST(BspFloats, FixedAndRestHoldTheFloatExactly) {
    std::mt19937 random(29);
    for (int i = 0; i < 20000; ++i) {
        const int exponent = -37 + static_cast<int>(random() % 38);
        const auto mantissa = static_cast<float>(0x800000 + random() % 0x800000);
        const float value = std::ldexp(mantissa, exponent - 23) * (random() % 2 == 0 ? 1.F : -1.F);
        const auto fixed = to_fixed(bits_of(value), 30, 2);
        ASSERT_TRUE(fixed.has_value());
        const std::int32_t rest = rest_of_fixed(bits_of(value), 30);
        ASSERT_LE(std::abs(rest), 1 << 29);
        // Both parts and the shifted float are whole and below 2^62: 64-bit integers compare them exactly.
        ASSERT_EQ(*fixed * (std::int64_t{1} << 30) + rest, static_cast<std::int64_t>(std::ldexp(value, 60))) << value;
    }
}

TEST(BspFloats, BoundsRoundOutward) {
    EXPECT_EQ(floor_to_int(bits_of(-1.25F)), -2);
    EXPECT_EQ(ceil_to_int(bits_of(-1.25F)), -1);
    EXPECT_EQ(floor_to_int(bits_of(7.F)), 7);
    EXPECT_EQ(ceil_to_int(bits_of(7.F)), 7);
    EXPECT_EQ(ceil_to_int(bits_of(1048576.F)), 1048576);
    EXPECT_FALSE(ceil_to_int(bits_of(1048577.F)).has_value());
    EXPECT_FALSE(floor_to_int(bits_of(kNan)).has_value());
}

TEST(BspFloats, TexelsOfAPolygonAreRoundedToCells) {
    const std::vector<FloatBits3> polygon = {bits_of(Place{-0.5F, 0, 0}), bits_of(Place{32, 100, 0}),
                                             bits_of(Place{16.5F, 50, 0})};
    const TexelRange range = texel_range(polygon, bits_of(Axis{1, 0, 0, 0}));
    EXPECT_EQ(range.min, -16);
    EXPECT_EQ(range.extent, 48);  // -16 to 32: a value on a border needs no further cell
    const TexelRange moved = texel_range(polygon, bits_of(Axis{1, 0, 0, 0.5F}));
    EXPECT_EQ(moved.min, 0);
    EXPECT_EQ(moved.extent, 48);  // 0 to 32.5
}

/// One step of a double's, so that nothing keeps more bits than a double has.
double stored(double value) {
    const volatile double kept = value;
    return kept;
}

/// texel / 16 in the machine's doubles, and then its float.
float cell_in_floats(const Place& p, const Axis& axis) {
    std::array<double, 3> products;
    for (std::size_t i = 0; i < 3; ++i) products[i] = stored(double{p[i]} * double{axis[i]});
    const double two = stored(products[0] + products[1]);
    const volatile float texel = static_cast<float>(stored(stored(two + products[2]) + double{axis[3]}));
    return texel / 16;
}

// Sums that lie at a cell's border or a few of a float's or a double's steps from it, where each rounding counts.
TEST(BspFloats, TexelsAreRoundedAsDoublesAreAndThenToFloats) {
    if (FLT_EVAL_METHOD != 0) GTEST_SKIP() << "this machine's doubles are rounded twice";
    std::mt19937 random(53);
    const auto small = [&] {
        const int exponent = -60 + static_cast<int>(random() % 70);
        return std::ldexp(static_cast<float>(random() % 64) - 32.F, exponent);
    };
    int on_border = 0;
    for (int i = 0; i < 200000; ++i) {
        const Place p{static_cast<float>(random() % 512) * 16.F - 4096.F, small(), small()};
        const Axis axis{1.F, small(), random() % 2 ? 1.F : small(), random() % 2 ? -p[1] * 2.F : small()};
        const TexelRange range = texel_range(std::vector{bits_of(p)}, bits_of(axis));
        const float cell = cell_in_floats(p, axis);
        ASSERT_EQ(range.min, 16 * std::floor(cell)) << "case " << i;
        ASSERT_EQ(range.min + range.extent, 16 * std::ceil(cell)) << "case " << i;
        on_border += range.extent == 0 ? 1 : 0;
    }
    EXPECT_GT(on_border, 1000);
}

TEST(BspFloats, TexelsTooSmallForFloatsAreZero) {
    const std::vector corner{bits_of(Place{-0x1p-100F, 0, 0})};
    // The least float, a tie between it and 0, and less.
    for (const auto& [axis, least] : {std::pair{0x1p-49F, -16}, {0x1p-50F, 0}, {0x1p-120F, 0}})
        EXPECT_EQ(texel_range(corner, bits_of(Axis{axis, 0, 0, 0})).min, least) << axis;
}

TEST(BspFloats, NumbersAreNamed) {
    for (const auto& [number, name] : {std::pair{1.5F, "1.500000"},
                                       {-2097152.25F, "-2097152.250000"},
                                       {1e-6F, "0.000001"},
                                       {std::numeric_limits<float>::max(), "2^127 or more"},
                                       {kNan, "nan"},
                                       {-kInfinity, "-inf"}})
        EXPECT_EQ(describe(bits_of(number)), name);
}

}  // namespace
}  // namespace oblong::test::bsp_floats_test
