#include "engine/fixed/arithmetic.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "engine/fixed/reciprocal.h"
#include "engine/fixed/share.h"

namespace oblong::test {

namespace {

__extension__ using Int128 = __int128;
using Fixed16 = Fixed<std::int32_t, 16>;

constexpr std::int32_t kLowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kHighest = std::numeric_limits<std::int32_t>::max();

Fixed16 quotient(std::int32_t a, std::int32_t b) {
    return divide<Fixed16>(Fixed16::from_raw(a), Fixed16::from_raw(b), Rounding::Floor);
}

Fixed16 product(std::int32_t a, std::int32_t b, Rounding rounding = Rounding::NearestHalfUp) {
    return multiply(Fixed16::from_raw(a), Fixed16::from_raw(b), rounding);
}

/// A number of any length, at the ends of its type now and then.
template <class Number>
Number any_number(std::mt19937_64& random) {
    const auto number = static_cast<Number>(random());
    const int shift = static_cast<int>(random() % (8 * sizeof(Number) + 2));
    if (shift >= static_cast<int>(8 * sizeof(Number)))
        return number < 0 ? std::numeric_limits<Number>::min() : std::numeric_limits<Number>::max();
    return floor_shift(number, shift);
}

/// The floor of a 2^16 / b in 64 bits, cut to 32.
std::int32_t expected_quotient(std::int64_t a, std::int64_t b) {
    const std::int64_t n = b < 0 ? -a * 65536 : a * 65536, d = std::abs(b);
    const std::int64_t floor = n / d - (n % d < 0 ? 1 : 0);
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(floor, kLowest, kHighest));
}

TEST(HardCaseA1, DivisionIsTotalAndSaturatesWithTheRightSign) {
    EXPECT_EQ(quotient(kLowest, -1), Fixed16::highest());
    EXPECT_EQ(quotient(kLowest, 1), Fixed16::lowest());
    EXPECT_EQ(quotient(kLowest, -65536), Fixed16::highest());  // 32768 does not fit
    EXPECT_EQ(quotient(kLowest, 65536), Fixed16::lowest());    // -32768 does
    EXPECT_EQ(quotient(1, 0), Fixed16::highest());
    EXPECT_EQ(quotient(-1, 0), Fixed16::lowest());
    EXPECT_EQ(quotient(0, 0), Fixed16{});
    EXPECT_EQ(quotient(20000 * 65536, 65536).raw, 20000 * 65536) << "a quotient that fits is exact";
}

TEST(HardCaseA2, SaturationBeginsExactlyWhereTheQuotientNoLongerFits) {
    for (const std::int32_t b : {1, 2, 3, 16 * 65536, 65535, 65536, 65537, kHighest, -1, -16 * 65536, -65536, kLowest})
        for (const std::int64_t limit : {std::int64_t{kHighest}, std::int64_t{kLowest}})
            for (std::int64_t near = -2; near <= 2; ++near) {
                const std::int64_t a = limit * b / 65536 + near;
                if (a < kLowest || a > kHighest) continue;
                ASSERT_EQ(quotient(static_cast<std::int32_t>(a), b).raw, expected_quotient(a, b)) << a << " / " << b;
            }
}

TEST(HardCaseA1, QuotientIsTheFloorOrSaturates) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20'000; ++i) {
        const auto a = any_number<std::int32_t>(random), b = any_number<std::int32_t>(random);
        if (b == 0) continue;
        ASSERT_EQ(quotient(a, b).raw, expected_quotient(a, b)) << a << " / " << b;
    }
}

TEST(HardCaseA3, ProductsRoundByOneRuleAndSaturate) {
    EXPECT_EQ(product(kHighest, kHighest), Fixed16::highest());  // 32767.99 * 32767.99
    EXPECT_EQ(product(kHighest, -kHighest), Fixed16::lowest());
    EXPECT_EQ(product(kLowest, kLowest), Fixed16::highest());
    EXPECT_EQ(product(-1, 32768).raw, 0) << "-1/2 ulp: the tie goes up";
    EXPECT_EQ(product(1, 32768).raw, 1);
    EXPECT_EQ(product(-1, 32768, Rounding::Floor).raw, -1);
    EXPECT_EQ(product(1, 32768, Rounding::Floor).raw, 0);
}

TEST(HardCaseA3, ProductOfTheNegativeIsWithinAStepOfTheNegativeProduct) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 20'000; ++i) {
        const auto a = any_number<std::int32_t>(random), b = any_number<std::int32_t>(random);
        if (a == kLowest) continue;
        for (const Rounding rounding : {Rounding::Floor, Rounding::NearestHalfUp}) {
            const std::int64_t sum = std::int64_t{product(a, b, rounding).raw} + product(-a, b, rounding).raw;
            ASSERT_TRUE(-1 <= sum && sum <= 1) << a << " * " << b;
        }
    }
}

TEST(Multiply, WideProductsEqualThoseOf128Bits) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 20'000; ++i) {
        const auto a = any_number<std::int64_t>(random), b = any_number<std::int64_t>(random);
        const Int128 exact = (Int128{a} * b) >> 42;
        const Int128 expected = std::clamp<Int128>(exact, std::numeric_limits<std::int64_t>::min(),
                                                   std::numeric_limits<std::int64_t>::max());
        const auto got = multiply(PlaneDistance::from_raw(a), PlaneDistance::from_raw(b), Rounding::Floor);
        ASSERT_TRUE(Int128{got.raw} == expected) << a << " * " << b;
    }
}

TEST(HardCaseA9, ShiftsOfNegativesFloorAtEveryWidth) {
    for (int bits = 0; bits < 64; ++bits) {
        EXPECT_EQ(floor_shift(std::int64_t{-1}, bits), -1);
        EXPECT_EQ(floor_shift(std::numeric_limits<std::int64_t>::min(), bits) + 1,
                  -((std::numeric_limits<std::int64_t>::max() >> bits)));
    }
    EXPECT_EQ(floor_shift(-5, 1), -3);
    EXPECT_EQ(rounded_shift(-5, 1, Rounding::NearestHalfUp), -2) << "-2.5: the tie goes up";
    EXPECT_EQ(rounded_shift(-6, 2, Rounding::NearestHalfUp), -1) << "-1.5";
    EXPECT_EQ(rounded_shift(-7, 2, Rounding::NearestHalfUp), -2) << "-1.75";
}

TEST(Conversion, SaturatesInBothDirections) {
    EXPECT_EQ(saturating_convert<Unit>(World::from_int(2)), Unit::highest());
    EXPECT_EQ(saturating_convert<Unit>(World::from_int(-2)), Unit::lowest());
    EXPECT_EQ(saturating_convert<Unit>(World::from_int(-3)), Unit::lowest());
    EXPECT_EQ(saturating_convert<Unit>(World::from_int(1)), Unit::from_int(1));
    EXPECT_EQ(saturating_convert<World>(View::from_int(524'288)), World::highest());
    EXPECT_EQ(saturating_convert<World>(View::highest()), World::highest());
    EXPECT_EQ(saturating_convert<World>(View::lowest()), World::lowest());
    EXPECT_EQ(saturating_convert<PlaneDistance>(View::lowest()), PlaneDistance::lowest());
}

/// Against doubles, which hold all of these numbers exactly.
TEST(Parts, AreThoseOfDoubles) {
    std::mt19937_64 random(4);
    for (int i = 0; i < 20'000; ++i) {
        const auto raw = any_number<std::int32_t>(random), other = any_number<std::int32_t>(random);
        const auto is = [](auto found, double expected) { return static_cast<double>(found) == expected; };
        const auto a = WorldWide::from_raw(raw), b = WorldWide::from_raw(other);
        const double steps = raw, value = steps / 4096;
        ASSERT_TRUE(is(floor_of<4>(a), std::floor(value * 16))) << raw << ", " << other;
        ASSERT_TRUE(is(floor_of<12>(a), steps)) << raw << ", " << other;
        ASSERT_TRUE(is(floor_of<20>(a), value * (1 << 20))) << raw << ", " << other;
        ASSERT_TRUE(is((a / 10).raw, std::trunc(steps / 10))) << raw << ", " << other;
        ASSERT_TRUE(is_within(a, WorldWide::from_int(256)) == (std::abs(value) < 256)) << raw << ", " << other;
        ASSERT_TRUE(is(magnitude(World::from_raw(raw)), std::abs(steps))) << raw << ", " << other;
        ASSERT_TRUE(is(World::from_raw(raw).bits(), raw < 0 ? steps + 0x1p32 : steps)) << raw << ", " << other;
        if (other == 0) continue;
        ASSERT_TRUE(is(a / b, std::trunc(steps / other))) << raw << ", " << other;
        const auto wide = Fixed<std::int64_t, 24>::from_raw(std::int64_t{raw} * 1000);
        ASSERT_TRUE(is(truncated_quotient<WorldWide>(wide, b).raw, std::trunc(steps * 1000 / other)))
            << raw << ", " << other;
    }
}

TEST(Sum, SaturatesInBothDirections) {
    EXPECT_EQ(saturating_sum(View::highest(), View::ulp()), View::highest());
    EXPECT_EQ(saturating_sum(View::lowest(), -View::ulp()), View::lowest());
    EXPECT_EQ(saturating_sum(View::highest(), View::lowest()), -View::ulp());
    EXPECT_EQ(saturating_sum(View::from_int(3), View::from_int(-5)), View::from_int(-2));
}

TEST(Reciprocal, OfTheLeastAndGreatest16Dot16Number) {
    using Fixed46 = Fixed<std::int64_t, 46>;
    EXPECT_EQ(reciprocal<Fixed46>(Fixed16::from_raw(1)), Fixed46::from_int(65536));
    EXPECT_EQ(reciprocal<Fixed46>(Fixed16::from_int(2)).raw, std::int64_t{1} << 45);
    EXPECT_EQ(reciprocal<Fixed46>(Fixed16::from_raw(kHighest)).raw, (std::int64_t{1} << 31) + 1)
        << "2^62 = (2^31 - 1)(2^31 + 1) + 1";
    EXPECT_EQ(reciprocal<Fixed46>(Fixed16{}), Fixed46::highest());
}

TEST(Reciprocal, IsTheNearest) {
    std::mt19937_64 random(5);
    for (int i = 0; i < 20'000; ++i) {
        const auto n = any_number<std::int32_t>(random);
        if (n == 0) continue;
        const Int128 r = reciprocal<Fixed<std::int64_t, 46>>(Fixed16::from_raw(n)).raw;
        const Int128 off = 2 * (r * n - (Int128{1} << 62));
        ASSERT_TRUE(off <= std::abs(std::int64_t{n}) && -off <= std::abs(std::int64_t{n})) << n;
    }
}

TEST(Log2Floor, AroundEveryPowerOfTwo) {
    for (int bit = 1; bit < 64; ++bit) {
        const std::uint64_t power = std::uint64_t{1} << bit;
        EXPECT_EQ(log2_floor(power), bit);
        EXPECT_EQ(log2_floor(power - 1), bit - 1);
        EXPECT_EQ(log2_floor(power + 1), bit);
    }
    EXPECT_EQ(log2_floor(1), 0);
}

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

using Number = Fixed<std::int64_t, 41>;

std::int64_t share_of(std::int64_t size, std::int64_t part, std::int64_t whole) {
    return Share(Number::from_raw(part), Number::from_raw(whole)).of(size);
}

/// Of any number of bits up to `bits`, so that small ones are tried too.
std::int64_t random_up_to(int bits, std::mt19937_64& random) {
    const int shift = 64 - static_cast<int>(1 + random() % static_cast<std::uint64_t>(bits));
    return static_cast<std::int64_t>(random() >> shift);
}

/// Shares by wide arithmetic, of numbers up to so many bits.
void expect_exact(int size_bits, int whole_bits, int trials) {
    std::mt19937_64 random(static_cast<std::uint64_t>(size_bits * 64 + whole_bits));
    for (int trial = 0; trial < trials; ++trial) {
        const std::int64_t whole = std::max<std::int64_t>(random_up_to(whole_bits, random), 1);
        const std::int64_t part = trial % 3 == 0 ? whole - random_up_to(whole_bits, random) % whole
                                                 : random_up_to(whole_bits, random) % (whole + 1);
        const std::int64_t size = random_up_to(size_bits, random) * (trial % 2 ? 1 : -1);
        ASSERT_EQ(share_of(size, part, whole), mul_div(size, part, whole)) << size << " * " << part << " / " << whole;
    }
}

}  // namespace

TEST(Share, IsThatOfWideArithmetic) {
    expect_exact(33, 57, 500'000);
    expect_exact(40, 62, 100'000);
    expect_exact(20, 20, 100'000);
}

/// A quotient of 30 bits is farthest off where the part is just below a multiple of 2^-30 of the whole.
TEST(Share, IsExactWhereTheQuotientIsFarthestOff) {
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 200'000; ++trial) {
        const std::int64_t whole = (std::int64_t{1} << 56) + random_up_to(56, random);
        const std::int64_t step = (whole >> 30) * static_cast<std::int64_t>(random() % (std::uint64_t{1} << 30));
        const std::int64_t part = std::clamp<std::int64_t>(step - 3 + trial % 7, 0, whole);
        const std::int64_t size = (std::int64_t{1} << 33) - trial % 5;
        ASSERT_EQ(share_of(size, part, whole), mul_div(size, part, whole));
        ASSERT_EQ(share_of(-size, part, whole), mul_div(-size, part, whole));
    }
}

}  // namespace oblong::test
