#include <gtest/gtest.h>

#include "engine/fixed/reciprocal.h"
#include "tests/exhaustive/first_failure.h"

// Every mantissa of 32 bits, 2^31 of them. The reference is the definition, r m = 2^62: no division is needed to
// check it, and none is done.

namespace oblong {
namespace {

constexpr std::uint64_t kFirst = kAll32 / 2;

/// r m - 2^62.
std::int64_t error_62(std::uint32_t mantissa, std::uint32_t r) {
    return static_cast<std::int64_t>(std::uint64_t{mantissa} * r - (std::uint64_t{1} << 62));
}

/// The reciprocal is right within 2^-Bits of itself and not above that of the mantissa before.
template <int Bits>
bool is_near_and_falls(std::uint64_t input, ReciprocalMethod method) {
    const auto mantissa = static_cast<std::uint32_t>(input);
    const std::uint32_t r = mantissa_reciprocal(mantissa, method);
    const bool falls = input == kFirst || r <= mantissa_reciprocal(mantissa - 1, method);
    return falls && std::abs(error_62(mantissa, r)) <= std::int64_t{1} << (62 - Bits);
}

TEST(HardCaseA4, ExactReciprocalOfEveryMantissaIsTheNearest) {
    EXPECT_EQ(first_failure(kFirst, kAll32,
                            [](std::uint64_t input) {
                                const auto mantissa = static_cast<std::uint32_t>(input);
                                const std::uint32_t r = mantissa_reciprocal(mantissa, ReciprocalMethod::Exact);
                                return 2 * std::abs(error_62(mantissa, r)) <= mantissa;
                            }),
              std::nullopt);
}

TEST(HardCaseA4, TwoStepsOfNewtonsAreWithinOneStepAndFallAtEveryMantissa) {
    EXPECT_EQ(first_failure(kFirst, kAll32,
                            [](std::uint64_t input) {
                                const auto mantissa = static_cast<std::uint32_t>(input);
                                constexpr auto kMethod = ReciprocalMethod::Table256TwoNewton;
                                const std::uint32_t r = mantissa_reciprocal(mantissa, kMethod);
                                const bool falls = input == kFirst || r <= mantissa_reciprocal(mantissa - 1, kMethod);
                                return falls && std::abs(error_62(mantissa, r)) <= mantissa;
                            }),
              std::nullopt);
}

TEST(HardCaseA5, Table256IsNearAndFallsAtEveryMantissa) {
    EXPECT_EQ(first_failure(kFirst, kAll32,
                            [](auto input) { return is_near_and_falls<9>(input, ReciprocalMethod::Table256); }),
              std::nullopt);
}

TEST(HardCaseA5, OneStepOfNewtonsFrom1024IsNearAndFallsAtEveryMantissa) {
    EXPECT_EQ(first_failure(kFirst, kAll32,
                            [](auto input) { return is_near_and_falls<21>(input, ReciprocalMethod::Table1024Newton); }),
              std::nullopt);
}

}  // namespace
}  // namespace oblong
