#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/fixed/sine_methods.h"
#include "engine/fixed/trig.h"
#include "tests/exhaustive/first_failure.h"

namespace oblong {
namespace {

constexpr long double kBam = std::numbers::pi_v<long double> / 32768;

/// tan of the limit between two neighbouring binary angles, times 2^62; the 80-bit tangent is right within 2^-62 of it,
/// so that 64 to either side are surely on its sides.
std::int64_t tangent_limit_62(int bam) {
    return static_cast<std::int64_t>(std::ldexp(std::tan((bam - 0.5L) * kBam), 62));
}

/// arctangent2's halving compares y / x with limits that grow, so that it rises with y / x; where it changes, it
/// changes at the limit. That is all inputs of the first eighth of a turn.
TEST(Arctangent, ChangesExactlyAtEveryLimitOfTheFirstEighth) {
    constexpr std::int64_t kOne62 = std::int64_t{1} << 62;
    expect_all(1, 8193, [](std::uint64_t input) {
        const auto bam = static_cast<int>(input);
        const std::int64_t limit = tangent_limit_62(bam);
        return arctangent2(limit + 64, kOne62).bam == bam && arctangent2(limit - 64, kOne62).bam == bam - 1;
    });
}

/// Every ratio of 2^24 to 1: never falls, and is right at the ends.
TEST(Arctangent, RisesOverTheWholeQuarter) {
    constexpr std::int64_t kSteps = std::int64_t{1} << 22;
    const auto at = [](std::uint64_t y) { return arctangent2(static_cast<std::int64_t>(y), kSteps).bam; };
    expect_all(1, 2 * kSteps, [&](std::uint64_t y) { return at(y - 1) <= at(y); });
}

TEST(Sine, EveryMethodAtEveryAngleStaysWithinItsStatedError) {
    // In the order of kSineMethods: powers of two that the worst errors stay below.
    constexpr std::array kErrorBits = {6.3, 13.6, 15.0, 21.6, 26.0, 30.999};
    for (std::size_t i = 0; i < kSineMethods.size(); ++i) {
        long double worst = 0;
        for (int bam = 0; bam < 65536; ++bam) {
            const Unit got = sine(Angle::from_bam(bam), kSineMethods[i]);
            worst =
                std::max(worst, std::abs(std::ldexp(static_cast<long double>(got.raw), -30) - std::sin(bam * kBam)));
        }
        EXPECT_LE(static_cast<double>(std::log2(worst)), -kErrorBits[i]) << "method " << i;
    }
}

}  // namespace
}  // namespace oblong
