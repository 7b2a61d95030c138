#include "engine/math/wide_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace oblong {
namespace {

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
