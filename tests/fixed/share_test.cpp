#include "engine/fixed/share.h"

#include <gtest/gtest.h>

#include <random>

namespace oblong::test {

namespace {

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

TEST(Share, OfATieIsTheUpperStep) {
    EXPECT_EQ(share_of(1, 1, 2), 1);
    EXPECT_EQ(share_of(-1, 1, 2), 0);
    EXPECT_EQ(share_of(-3, 1, 2), -1);
    EXPECT_EQ(share_of(7, 0, 5), 0);
    EXPECT_EQ(share_of(-7, 5, 5), -7);
}

}  // namespace oblong::test
