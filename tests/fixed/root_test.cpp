#include "engine/fixed/root.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/fixed/power.h"
#include "engine/methods/square_root.h"

namespace oblong::test::root_test {

namespace {

__extension__ using Uint128 = unsigned __int128;

/// r r <= value < (r + 1)(r + 1), the definition.
bool is_root(std::uint64_t r, Uint128 value) {
    const Uint128 square = Uint128{r} * r;
    return square <= value && value - square <= 2 * Uint128{r};
}

Uint128 joined(oblong::Uint128 value) {
    return (Uint128{value.high} << 64) | value.low;
}

TEST(HardCaseA6, RootAroundEveryPowerOfTwo) {
    for (int bit = 0; bit < 64; ++bit)
        for (std::uint64_t off = 0; off < 3; ++off) {
            const std::uint64_t value = (std::uint64_t{1} << bit) - 1 + off;
            ASSERT_TRUE(is_root(integer_root(value), value)) << value;
        }
    EXPECT_EQ(integer_root(std::numeric_limits<std::uint64_t>::max()), 0xffffffffu);
}

TEST(HardCaseA6, RootOfRandomNumbersOfEveryLength) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 1'000'000; ++i) {
        const oblong::Uint128 value{random() >> (random() % 64), random()};
        ASSERT_TRUE(is_root(integer_root(value.high), value.high)) << value.high;
        ASSERT_TRUE(is_root(integer_root(value), joined(value))) << value.high << " " << value.low;
    }
}

/// r^2 - 1, r^2 and r^2 + 2 r for roots of every length, long runs of ones among them: where a digit is one too great.
TEST(HardCaseA6, RootOf128BitNumbersNextToSquares) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 300'000; ++i) {
        const std::uint64_t r = (i % 2 == 0 ? random() : ~(random() >> (random() % 64))) >> (random() % 60);
        const oblong::Uint128 square = native::product_to_128(r, r);
        if (r == 0) continue;
        const oblong::Uint128 below{square.low == 0 ? square.high - 1 : square.high, square.low - 1};
        ASSERT_EQ(integer_root(square), r);
        ASSERT_EQ(integer_root(below), r - 1);
        const Uint128 last = joined(square) + 2 * Uint128{r};
        ASSERT_EQ(
            integer_root(oblong::Uint128{static_cast<std::uint64_t>(last >> 64), static_cast<std::uint64_t>(last)}), r);
    }
}

TEST(SquareRoot, OfA16Dot16NumberIsTheNearestOf32FractionBits) {
    using Fixed16 = Fixed<std::int32_t, 16>;
    using Fixed32 = Fixed<std::int64_t, 32>;
    EXPECT_EQ(square_root<Fixed32>(Fixed16::from_int(4), Rounding::NearestHalfUp), Fixed32::from_int(2));
    EXPECT_EQ(square_root<Fixed32>(Fixed16::from_int(2), Rounding::NearestHalfUp).raw, 6074001000);  // 6074000999.95
    EXPECT_EQ(square_root<Fixed32>(Fixed16::from_int(2), Rounding::Floor).raw, 6074000999);
    std::mt19937 random(4);
    for (int i = 0; i < 200'000; ++i) {
        const auto n = static_cast<std::int32_t>(random() >> 1 >> (random() % 31));
        const Uint128 exact = Uint128{static_cast<std::uint32_t>(n)} << 48;
        const auto r =
            static_cast<std::uint64_t>(square_root<Fixed32>(Fixed16::from_raw(n), Rounding::NearestHalfUp).raw);
        // |r - root| <= 1/2 as squares: (2 r - 1)^2 <= 4 exact <= (2 r + 1)^2.
        ASSERT_TRUE(r == 0 || Uint128{2 * r - 1} * (2 * r - 1) <= 4 * exact) << n;
        ASSERT_TRUE(Uint128{2 * r + 1} * (2 * r + 1) >= 4 * exact) << n;
    }
}

/// |r root(value) - 1| <= 2^-27, as squares: r^2 value within 2^-26 of 1, the mantissa scaled by 2^(30 + shift).
TEST(ReciprocalRoot, IsWithinItsBound) {
    std::mt19937_64 random(5);
    const auto check = [](std::uint64_t value) {
        const ReciprocalRoot r = reciprocal_root(value);
        ASSERT_GE(r.mantissa, (1u << 30) - 8) << value;
        ASSERT_LE(r.mantissa, (1u << 31)) << value;
        const Uint128 square = Uint128{r.mantissa} * r.mantissa;  // of 2^(60 + 2 shift) / value
        const Uint128 scaled =
            r.shift >= 2 ? square * (value >> (2 * r.shift - 4)) : square * (value << (4 - 2 * r.shift));
        const Uint128 one = Uint128{1} << 64, cut = r.shift >= 2 ? square : 0;  // what value loses when it is shifted
        ASSERT_GE(scaled + cut, one - (one >> 26)) << value;
        ASSERT_LE(scaled, one + (one >> 26)) << value;
    };
    for (int bit = 0; bit < 64; ++bit)
        for (std::uint64_t off = 0; off < 3; ++off)
            check(std::max<std::uint64_t>((std::uint64_t{1} << bit) - 1 + off, 1));
    for (int i = 0; i < 300'000; ++i) check(std::max<std::uint64_t>(random() >> (random() % 64), 1));
}

TEST(SquareRoot, OfNegativesIsZero) {
    EXPECT_EQ(square_root<World>(World::from_int(-1)), World{});
}

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

TEST(Power, OfTheEndsIsExact) {
    for (const std::uint32_t exponent : {1u, 7u, 1u << 20}) {
        EXPECT_EQ(power_30(0, exponent, 3), 0u);
        EXPECT_EQ(power_30(kOne_30, exponent, 3), kOne_30);
    }
    for (const std::uint32_t base : {1u, kOne_30 / 2}) EXPECT_EQ(power_30(base, 1 << 20, 1), 0u) << base;
}

}  // namespace

}  // namespace oblong::test::root_test
