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

/// The first mantissa whose reciprocal is off by more than `limit_62(mantissa)` in 2^-62, or above that of the mantissa
/// before.
template <class Limit>
std::optional<std::uint64_t> first_off_or_rising(ReciprocalMethod method, Limit limit_62) {
    return first_rise_or_far(
        kFirst, kAll32,
        [=](std::uint64_t input) { return mantissa_reciprocal(static_cast<std::uint32_t>(input), method); },
        [=](std::uint64_t input, std::uint32_t r) {
            const auto mantissa = static_cast<std::uint32_t>(input);
            return std::abs(error_62(mantissa, r)) <= limit_62(mantissa);
        });
}

/// What is right within 2^-bits of itself.
auto relative_limit(int bits) {
    return [=](std::uint32_t) { return std::int64_t{1} << (62 - bits); };
}

TEST(HardCaseA4, ExactReciprocalOfEveryMantissaIsTheNearest) {
    expect_all(kFirst, kAll32, [](std::uint64_t input) {
        const auto mantissa = static_cast<std::uint32_t>(input);
        const std::uint32_t r = mantissa_reciprocal(mantissa, ReciprocalMethod::Exact);
        return 2 * std::abs(error_62(mantissa, r)) <= mantissa;
    });
}

TEST(HardCaseA4, TwoStepsOfNewtonsAreWithinOneStepAndFallAtEveryMantissa) {
    const auto a_step = [](std::uint32_t mantissa) { return std::int64_t{mantissa}; };
    EXPECT_EQ(first_off_or_rising(ReciprocalMethod::Table256TwoNewton, a_step), std::nullopt);
}

TEST(HardCaseA5, Table256IsNearAndFallsAtEveryMantissa) {
    EXPECT_EQ(first_off_or_rising(ReciprocalMethod::Table256, relative_limit(9)), std::nullopt);
}

TEST(HardCaseA5, OneStepOfNewtonsFrom1024IsNearAndFallsAtEveryMantissa) {
    EXPECT_EQ(first_off_or_rising(ReciprocalMethod::Table1024Newton, relative_limit(21)), std::nullopt);
}

}  // namespace
}  // namespace oblong
