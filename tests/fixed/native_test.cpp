#include "engine/fixed/native/native.h"

#include <gtest/gtest.h>

#include <random>

namespace oblong::test {
namespace {

__extension__ using Wide = __int128;

constexpr Wide floored(Wide value, int shift) {
    return value >> shift;
}

// What plain.h says, in 128 bits. On an i386 this is its machine code; tests/dos compares it with the plain one there.
TEST(Native, IsWhatItsCommentsSay) {
    std::mt19937_64 random(1);
    const auto any = [&] { return random() >> random() % 64; };
    for (int trial = 0; trial < 200'000; ++trial) {
        const std::uint64_t a = any(), b = any();
        const auto a_32 = static_cast<std::uint32_t>(any()), b_32 = static_cast<std::uint32_t>(any()),
                   count = static_cast<std::uint32_t>(any());
        const auto signed_a = static_cast<std::int32_t>(random()), signed_b = static_cast<std::int32_t>(any()),
                   low = static_cast<std::int32_t>(random());
        const auto signed_64 = static_cast<std::int64_t>(random());
        const int shift = 1 + static_cast<int>(random() % 31);
        ASSERT_EQ(native::product_to_64(a_32, b_32), static_cast<std::uint64_t>(Wide{a_32} * b_32));
        ASSERT_EQ(native::product_to_64(signed_a, signed_b), static_cast<std::int64_t>(Wide{signed_a} * signed_b));
        const Uint128 product = native::product_to_128(a, b);
        ASSERT_TRUE((static_cast<unsigned __int128>(product.high) << 64 | product.low) ==
                    static_cast<unsigned __int128>(a) * b);
        ASSERT_EQ(native::wrapping_sum(a, b, count), static_cast<std::uint64_t>(Wide{b} * count + a));
        const std::uint32_t divisor = b_32 | 1;
        const std::uint64_t number = a % (std::uint64_t{divisor} << 32);
        ASSERT_EQ(native::divide_to_32(number, divisor).quotient, number / divisor);
        ASSERT_EQ(native::divide_to_32(number, divisor).remainder, number % divisor);
        ASSERT_EQ(native::shift_right({signed_64, a_32}, shift),
                  static_cast<std::int64_t>(floored(Wide{signed_64} * (Wide{1} << 32) + a_32, shift)));
        const auto upper = static_cast<std::uint32_t>(floored(Wide{signed_64} * (Wide{1} << shift), 32));
        ASSERT_EQ(native::shift_left(signed_64, shift).bits, upper);
        ASSERT_EQ(native::shift_left(signed_64, shift).is_below_zero, upper >= 1u << 31);
        ASSERT_EQ(native::product_above_one(a_32, b_32),
                  static_cast<std::uint64_t>(Wide{a_32} * ((Wide{1} << 32) + 1 + b_32)));
        ASSERT_EQ(native::is_in_range(a_32, b_32, count),
                  a_32 >= b_32 ? a_32 - b_32 < count : Wide{a_32} + (Wide{1} << 32) - b_32 < count);
        const std::int64_t d = 1 + (b_32 >> 2);
        if (const Wide whole = Wide{signed_b} * signed_a; whole < (Wide{d} << 33) && whole > -(Wide{d} << 33)) {
            const Wide numerator = whole + (Wide{d} << 7), by = Wide{d} << 8;
            const Wide rounded = numerator / by - (numerator % by < 0);
            ASSERT_EQ(native::rounded_quotient_8(signed_b, signed_a, static_cast<std::uint32_t>(d)),
                      static_cast<std::int32_t>(rounded));
        }
        ASSERT_EQ(native::rounded_product_48(signed_a, low, signed_b),
                  static_cast<std::int64_t>(
                      floored(Wide{signed_a} * (Wide{signed_b} * (Wide{1} << 32) + low) + (Wide{1} << 47), 48)));
    }
}

}  // namespace
}  // namespace oblong::test
