#include "engine/math/soft_float.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/fixed/arithmetic.h"

namespace oblong {

namespace {

long double value_of(const SoftFloat& scaled) {
    return std::ldexp(static_cast<long double>(scaled.mantissa), scaled.exponent);
}

SoftFloat any_scaled(std::mt19937_64& random) {
    const auto mantissa = floor_shift(static_cast<std::int64_t>(random()), static_cast<int>(random() % 64));
    return SoftFloat::from(mantissa, static_cast<int>(random() % 80) - 40);
}

TEST(SoftFloat, MantissaHas62BitsAndTheValueOfANumberIsKept) {
    for (const std::int64_t number : {std::int64_t{1}, std::int64_t{-1}, std::int64_t{12'345}, std::int64_t{1} << 62,
                                      std::numeric_limits<std::int64_t>::min()}) {
        const SoftFloat scaled = SoftFloat::from(number, -3);
        EXPECT_EQ(value_of(scaled), std::ldexp(static_cast<long double>(number), -3));
        EXPECT_EQ(log2_floor(detail::magnitude(scaled.mantissa)), 61);
        EXPECT_LT(std::abs(value_of(scaled)), std::ldexp(1.0L, scaled.magnitude()));
    }
    EXPECT_TRUE(SoftFloat::from(0, 99).is_zero());
}

TEST(SoftFloat, ResultsHoldTheirRelativeError) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 200'000; ++i) {
        const SoftFloat a = any_scaled(random), b = any_scaled(random);
        const long double x = value_of(a), y = value_of(b), larger = std::max(std::abs(x), std::abs(y));
        ASSERT_LE(std::abs(value_of(a * b) - x * y), std::abs(x * y) * 0x1p-60L);
        ASSERT_LE(std::abs(value_of(a - b) - (x - y)), larger * 0x1p-60L);
        ASSERT_LE(std::abs(value_of(a + b) - (x + y)), larger * 0x1p-60L);
        if (b.is_zero()) continue;
        ASSERT_LE(std::abs(value_of(a / b) - x / y), std::abs(x / y) * 0x1p-60L);
    }
}

TEST(SoftFloat, BecomesFixedOrSaysThatItDoesNotFit) {
    EXPECT_EQ(fixed_of(SoftFloat::from(5, -1), 32), std::int64_t{5} << 31);
    EXPECT_EQ(fixed_of(SoftFloat::from(1, -34), 32), 0) << "a quarter of a step";
    EXPECT_EQ(fixed_of(SoftFloat::from(-3, -33), 32), -1) << "-1.5 steps: the tie goes up";
    EXPECT_EQ(fixed_of(SoftFloat::from(1, -200), 32), 0);
    EXPECT_EQ(fixed_of(SoftFloat::from((1 << 30) - 1, 0), 32), ((std::int64_t{1} << 30) - 1) << 32);
    EXPECT_EQ(fixed_of(SoftFloat::from(1 << 30, 0), 32), std::nullopt);
}

__extension__ using Int128 = __int128;

/// |value| has at most 62 bits once those below are dropped: toward 0, as WideSum does.
void expect_leading_bits(Int128 exact, const SoftFloat& found) {
    const Int128 size = exact < 0 ? -exact : exact;
    int drop = 0;
    while (size >> drop >= Int128{1} << 62) ++drop;
    const auto leading = static_cast<std::int64_t>(size >> drop);
    EXPECT_EQ(found.mantissa, SoftFloat::from(exact < 0 ? -leading : leading, drop).mantissa);
    EXPECT_EQ(found.exponent, SoftFloat::from(leading, drop).exponent);
}

TEST(WideSum, KeepsTheLeadingBitsOfTheExactSum) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        WideSum sum;
        Int128 exact = 0;
        for (int term = 0; term < 3; ++term) {
            const auto a = floor_shift(static_cast<std::int64_t>(random()), static_cast<int>(2 + random() % 62));
            const auto b = floor_shift(static_cast<std::int64_t>(random()), static_cast<int>(2 + random() % 62));
            sum.add_product(a, b);
            exact += Int128{a} * b;
        }
        ASSERT_NO_FATAL_FAILURE(expect_leading_bits(exact, sum.scaled(0))) << i;
    }
}

TEST(WideSum, LosesNothingWhereLargeProductsCancel) {
    WideSum sum;
    sum.add_product(std::int64_t{1} << 62, std::int64_t{1} << 62);
    sum.add_product((std::int64_t{1} << 62) - 1, -((std::int64_t{1} << 62) + 1));  // 2^124 - (2^124 - 1) = 1
    EXPECT_EQ(fixed_of(sum.scaled(-5), 5), 1);
    sum.add_product(-1, 1);
    EXPECT_TRUE(sum.scaled(0).is_zero());
}

}  // namespace

}  // namespace oblong
