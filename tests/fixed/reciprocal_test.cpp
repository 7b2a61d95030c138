#include "engine/fixed/reciprocal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace oblong {
namespace {

// All 2^31 mantissas are tried in tests/exhaustive; here a dense set of them.

TEST(HardCaseA4, ErrorOfEachMethodStaysBelowWhatItsNameStates) {
    // In the order of kReciprocalMethods: powers of two that the worst errors stay below.
    constexpr std::array kErrorBits = {9, 18, 21, 30, 31};
    for (std::size_t i = 0; i < kReciprocalMethods.size(); ++i)
        for (std::uint64_t m = std::uint64_t{1} << 31; m < std::uint64_t{1} << 32; m += 65'521) {
            const std::uint64_t r = mantissa_reciprocal(static_cast<std::uint32_t>(m), kReciprocalMethods[i]);
            const auto error_62 = static_cast<std::int64_t>(r * m - (std::uint64_t{1} << 62));
            ASSERT_LE(std::abs(error_62), std::int64_t{1} << (62 - kErrorBits[i])) << "method " << i << ", " << m;
        }
}

/// A step of Newton's from 256 entries does rise where an entry begins: by what its comment says.
constexpr std::uint32_t allowed_rise(ReciprocalMethod method) {
    return method == ReciprocalMethod::Table256Newton ? 1 << 6 : 0;
}

TEST(HardCaseA5, ReciprocalNeverRisesWithDepth) {
    for (const ReciprocalMethod method : kReciprocalMethods) {
        std::uint32_t before = mantissa_reciprocal(0x80000000, method);
        for (std::uint64_t m = 0x80000001; m < 0x100000000; m += 7'919) {
            const std::uint32_t r = mantissa_reciprocal(static_cast<std::uint32_t>(m), method);
            ASSERT_LE(r, before + allowed_rise(method)) << static_cast<int>(method) << " " << m;
            before = r;
        }
    }
}

TEST(HardCaseA5, ReciprocalNeverRisesWhereAPartOfTheTableEnds) {
    for (const ReciprocalMethod method : kReciprocalMethods)
        for (std::uint32_t part = 1; part < 1024; ++part) {
            const std::uint32_t first = 0x80000000 + (part << 21);
            ASSERT_LE(mantissa_reciprocal(first, method), mantissa_reciprocal(first - 1, method) + allowed_rise(method))
                << static_cast<int>(method) << " " << part;
        }
}

}  // namespace
}  // namespace oblong
