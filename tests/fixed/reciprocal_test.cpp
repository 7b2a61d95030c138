#include "engine/fixed/reciprocal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace oblong {
namespace {

// All 2^31 mantissas are tried in tests/exhaustive; here a dense set of them.

TEST(HardCaseA4, ErrorOfEachMethodStaysBelowWhatItsNameStates) {
    constexpr std::array kErrorBits = {9, 21, 30, 31};
    for (std::size_t i = 0; i < kReciprocalMethods.size(); ++i)
        for (std::uint64_t m = std::uint64_t{1} << 31; m < std::uint64_t{1} << 32; m += 65'521) {
            const std::uint64_t r = mantissa_reciprocal(static_cast<std::uint32_t>(m), kReciprocalMethods[i]);
            const auto error_62 = static_cast<std::int64_t>(r * m - (std::uint64_t{1} << 62));
            ASSERT_LE(std::abs(error_62), std::int64_t{1} << (62 - kErrorBits[i]))
                << name_of(kReciprocalMethods[i]) << " " << m;
        }
}

TEST(HardCaseA5, ReciprocalNeverRisesWithDepth) {
    for (const ReciprocalMethod method : kReciprocalMethods) {
        std::uint32_t before = mantissa_reciprocal(0x80000000, method);
        for (std::uint64_t m = 0x80000001; m < 0x100000000; m += 7'919) {
            const std::uint32_t r = mantissa_reciprocal(static_cast<std::uint32_t>(m), method);
            ASSERT_LE(r, before) << name_of(method) << " " << m;
            before = r;
        }
    }
}

TEST(HardCaseA5, ReciprocalNeverRisesWhereAPartOfTheTableEnds) {
    for (const ReciprocalMethod method : kReciprocalMethods)
        for (std::uint32_t part = 1; part < 1024; ++part) {
            const std::uint32_t first = 0x80000000 + (part << 21);
            ASSERT_LE(mantissa_reciprocal(first, method), mantissa_reciprocal(first - 1, method))
                << name_of(method) << " " << part;
        }
}

TEST(ScaledReciprocal, HoldsItsErrorForIntegersOfEveryLength) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 100'000; ++i) {
        const std::uint64_t n = (random() | 1) >> (random() % 63);
        if (n == 0) continue;
        const auto [mantissa, shift] = scaled_reciprocal(n, ReciprocalMethod::Exact);
        const long double product =
            std::ldexp(static_cast<long double>(mantissa) * static_cast<long double>(n), -shift);
        ASSERT_LE(std::abs(product - 1), 0x1.8p-30L) << n;
    }
}

TEST(ScaledReciprocal, OfPowersOfTwoIsExact) {
    for (int bit = 0; bit < 64; ++bit) {
        const auto [mantissa, shift] = scaled_reciprocal(std::uint64_t{1} << bit, ReciprocalMethod::Exact);
        EXPECT_EQ(mantissa, 0x80000000);
        EXPECT_EQ(shift, 31 + bit);
    }
}

}  // namespace
}  // namespace oblong
