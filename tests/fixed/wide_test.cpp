#include "engine/fixed/wide.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

namespace oblong::test::wide_test {
namespace {

__extension__ using Int128 = __int128;

constexpr std::int64_t kLowest = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kHighest = std::numeric_limits<std::int64_t>::max();

/// The floor of n / d by its definition: q d <= n < (q + 1) d, d above 0.
Int128 floor_quotient(Int128 n, Int128 d) {
    const Int128 q = n / d;
    return q * d > n ? q - 1 : q;
}

/// n / d, rounded as the rule says: nearest with ties up is the floor of (2 n + d) / (2 d).
std::int64_t expected_quotient(Int128 n, Int128 d, Rounding rounding) {
    if (d == 0) return n > 0 ? kHighest : n < 0 ? kLowest : 0;
    if (d < 0) {
        n = -n;
        d = -d;
    }
    const Int128 q = floor_quotient(n, d);
    const bool up = rounding == Rounding::NearestHalfUp && n - q * d >= d - (n - q * d);
    const Int128 rounded = up ? q + 1 : q;
    return rounded > kHighest ? kHighest : rounded < kLowest ? kLowest : static_cast<std::int64_t>(rounded);
}

constexpr std::array kEdges = {
    kLowest,          kLowest + 1,         std::int64_t{-1} << 32, std::int64_t{-65537},  std::int64_t{-3},
    std::int64_t{-2}, std::int64_t{-1},    std::int64_t{0},        std::int64_t{1},       std::int64_t{2},
    std::int64_t{3},  std::int64_t{65536}, std::int64_t{1} << 31,  std::int64_t{1} << 62, kHighest - 1,
    kHighest};

/// Numbers of every length, not only of 63 bits.
std::int64_t any_number(std::mt19937_64& random) {
    const auto bits = static_cast<std::int64_t>(random());
    return floor_shift(bits, static_cast<int>(random() % 64));
}

void expect_all_quotients_equal(std::int64_t a, std::int64_t b, std::int64_t c) {
    for (const Rounding rounding : {Rounding::Floor, Rounding::NearestHalfUp}) {
        const std::int64_t expected = expected_quotient(Int128{a} * b, c, rounding);
        ASSERT_EQ(mul_div(a, b, c, rounding), expected) << a << " * " << b << " / " << c;
        ASSERT_EQ(portable::mul_div(a, b, c, rounding), expected) << a << " * " << b << " / " << c;
    }
}

void expect_all_shifts_equal(std::int64_t a, std::int64_t b, int shift) {
    for (const Rounding rounding : {Rounding::Floor, Rounding::NearestHalfUp}) {
        const std::int64_t expected = expected_quotient(Int128{a} * b, Int128{1} << shift, rounding);
        ASSERT_EQ(mul_shift(a, b, shift, rounding), expected) << a << " * " << b << " >> " << shift;
        ASSERT_EQ(portable::mul_shift(a, b, shift, rounding), expected) << a << " * " << b << " >> " << shift;
    }
}

/// floor((a b + 2^(shift - 1)) / 2^shift), its lowest 64 bits.
void expect_wrapped_shifts_equal(std::int32_t a, std::int64_t b) {
    for (int shift = 1; shift <= 32; ++shift) {
        const Int128 step = Int128{1} << shift;
        const auto expected = static_cast<std::int64_t>(floor_quotient(Int128{a} * b + step / 2, step));
        ASSERT_EQ(wrapping_mul_shift(a, b, shift), expected) << a << " * " << b << " >> " << shift;
        ASSERT_EQ(portable::wrapping_mul_shift(a, b, shift), expected) << a << " * " << b << " >> " << shift;
    }
}

TEST(Wide, QuotientOfEveryTripleOfEdgesIsExactlyRoundedOrSaturates) {
    for (const std::int64_t a : kEdges)
        for (const std::int64_t b : kEdges)
            for (const std::int64_t c : kEdges) expect_all_quotients_equal(a, b, c);
}

TEST(Wide, QuotientOfRandomNumbersOfEveryLengthIsExactlyRounded) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 200'000; ++i)
        expect_all_quotients_equal(any_number(random), any_number(random), any_number(random));
}

TEST(Wide, WrappedShiftedProductIsExactlyRoundedModulo2To64) {
    std::mt19937_64 random(3);
    for (const std::int64_t a : kEdges)
        for (const std::int64_t b : kEdges) expect_wrapped_shifts_equal(static_cast<std::int32_t>(a), b);
    for (int i = 0; i < 20'000; ++i)
        expect_wrapped_shifts_equal(static_cast<std::int32_t>(any_number(random)), any_number(random));
}

TEST(Wide, ShiftedProductOfEveryPairOfEdgesIsExactlyRoundedOrSaturates) {
    for (const std::int64_t a : kEdges)
        for (const std::int64_t b : kEdges)
            for (int shift = 0; shift <= 126; ++shift) expect_all_shifts_equal(a, b, shift);
}

TEST(Wide, ShiftedProductOfRandomNumbersOfEveryLengthIsExactlyRounded) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 500'000; ++i)
        expect_all_shifts_equal(any_number(random), any_number(random), static_cast<int>(random() % 127));
}

TEST(Wide, FlooredDivisionLeavesARestFromZeroToBelowTheDivisor) {
    std::mt19937_64 random(4);
    for (int i = 0; i < 200'000; ++i) {
        const std::int64_t n = any_number(random), d = any_number(random);
        if (d <= 0) continue;
        const auto [quotient, rest] = floored_division(n, d);
        ASSERT_EQ(Int128{quotient} * d + rest, n) << n << " / " << d;
        ASSERT_TRUE(rest >= 0 && rest < d) << n << " / " << d;
    }
}

TEST(Wide, ProductsCompareAsTheirExactValues) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 100'000; ++i) {
        const auto a = detail::magnitude(any_number(random)), b = detail::magnitude(any_number(random));
        const auto c = detail::magnitude(any_number(random)), d = detail::magnitude(any_number(random));
        __extension__ using Uint128 = unsigned __int128;
        const auto expected = Uint128{a} * b <=> Uint128{c} * d;
        ASSERT_EQ(compare_products(a, b, c, d), expected);
        ASSERT_EQ(portable::compare_products(a, b, c, d), expected);
        ASSERT_EQ(portable::compare_products(a, b, b, a), std::strong_ordering::equal);
    }
}

}  // namespace
}  // namespace oblong::test::wide_test
