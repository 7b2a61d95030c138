#include "engine/fixed/power.h"

#include <gtest/gtest.h>

#include <cmath>

namespace oblong {
namespace {

constexpr std::uint32_t kOne_30 = 1 << 30;

TEST(Power, AgreesWithDoubles) {
    constexpr double kBound = 1.0 / (1 << 20);
    for (const auto& [numerator, denominator] : {std::pair{1u, 1u}, {1u, 3u}, {12u, 5u}, {3u, 1u}, {50u, 100u}})
        for (std::uint32_t base_30 = 1; base_30 <= kOne_30; base_30 += 1 + base_30 / 64) {
            const double truth = std::pow(base_30 / double(kOne_30), double(numerator) / denominator);
            ASSERT_NEAR(power_30(base_30, numerator, denominator) / double(kOne_30), truth, kBound)
                << base_30 << " to the power of " << numerator << " / " << denominator;
        }
}

TEST(Power, OfZeroAndOneIsItself) {
    for (const std::uint32_t exponent : {1u, 7u, 1u << 20}) {
        EXPECT_EQ(power_30(0, exponent, 3), 0u);
        EXPECT_EQ(power_30(kOne_30, exponent, 3), kOne_30);
    }
}

TEST(Power, LargeExponentsComeToNothing) {
    EXPECT_EQ(power_30(kOne_30 / 2, 1 << 20, 1), 0u);
    EXPECT_EQ(power_30(1, 1 << 20, 1), 0u);
}

}  // namespace
}  // namespace oblong
