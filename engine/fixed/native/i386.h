#pragma once

#include <cstdint>
#include <type_traits>

#include "engine/fixed/native/plain.h"

// plain.h for i386, whose compilers keep each number of 64 bits in a pair of registers and call functions to divide it.

namespace oblong::on_i386 {

inline constexpr bool kHasShortRegisters = true;

constexpr std::int64_t product_to_64(std::int32_t a, std::int32_t b) {
    if (std::is_constant_evaluated()) return plain::product_to_64(a, b);
    std::int64_t product;
    asm("imull %2" : "=A"(product) : "%a"(a), "rm"(b) : "cc");
    return product;
}

constexpr std::uint64_t product_to_64(std::uint32_t a, std::uint32_t b) {
    if (std::is_constant_evaluated()) return plain::product_to_64(a, b);
    std::uint64_t product;
    asm("mull %2" : "=A"(product) : "%a"(a), "rm"(b) : "cc");
    return product;
}

/// Carries go from addition to addition; GCC puts each into a number of 64 bits.
constexpr Uint128 product_to_128(std::uint64_t a, std::uint64_t b) {
    if (std::is_constant_evaluated()) return plain::product_to_128(a, b);
    const auto low_a = static_cast<std::uint32_t>(a), high_a = static_cast<std::uint32_t>(a >> 32),
               low_b = static_cast<std::uint32_t>(b), high_b = static_cast<std::uint32_t>(b >> 32);
    const std::uint64_t first = product_to_64(low_a, low_b);
    std::uint32_t second = static_cast<std::uint32_t>(first >> 32), third = 0, fourth = 0;
    asm("movl %[low_a], %%eax\n\tmull %[high_b]\n\taddl %%eax, %[second]\n\tadcl $0, %%edx\n\t"
        "movl %%edx, %[third]\n\t"
        "movl %[high_a], %%eax\n\tmull %[low_b]\n\taddl %%eax, %[second]\n\tadcl %%edx, %[third]\n\t"
        "movl $0, %[fourth]\n\tadcl $0, %[fourth]\n\t"
        "movl %[high_a], %%eax\n\tmull %[high_b]\n\taddl %%eax, %[third]\n\tadcl %%edx, %[fourth]"
        : [second] "+&r"(second), [third] "=&r"(third), [fourth] "=&r"(fourth)
        : [low_a] "m"(low_a), [high_a] "m"(high_a), [low_b] "m"(low_b), [high_b] "m"(high_b)
        : "eax", "edx", "cc");
    return {std::uint64_t{fourth} << 32 | third, std::uint64_t{second} << 32 | static_cast<std::uint32_t>(first)};
}

[[gnu::always_inline]] constexpr std::uint64_t wrapping_sum(std::uint64_t value, std::uint64_t step,
                                                            std::uint32_t count) {
    if (std::is_constant_evaluated()) return plain::wrapping_sum(value, step, count);
    const std::uint32_t upper = static_cast<std::uint32_t>(step >> 32) * count;
    std::uint32_t low = static_cast<std::uint32_t>(step), high = 0;
    asm("mull %[count]\n\taddl %[upper], %1\n\taddl %[value_low], %0\n\tadcl %[value_high], %1"
        : "+&a"(low), "=&d"(high)
        : [count] "rm"(count), [upper] "rm"(upper), [value_low] "rm"(static_cast<std::uint32_t>(value)),
          [value_high] "rm"(static_cast<std::uint32_t>(value >> 32))
        : "cc");
    return std::uint64_t{high} << 32 | low;
}

constexpr ShortDivision divide_to_32(std::uint64_t n, std::uint32_t d) {
    if (std::is_constant_evaluated()) return plain::divide_to_32(n, d);
    ShortDivision result;
    asm("divl %4"
        : "=a"(result.quotient), "=d"(result.remainder)
        : "a"(static_cast<std::uint32_t>(n)), "d"(static_cast<std::uint32_t>(n >> 32)), "rm"(d)
        : "cc");
    return result;
}

/// In place: GCC moves the halves of numbers of 64 bits about.
[[gnu::always_inline]] constexpr std::int64_t shift_right(Int96 value, int shift) {
    if (std::is_constant_evaluated()) return plain::shift_right(value, shift);
    std::uint32_t low = value.low, middle = static_cast<std::uint32_t>(value.high);
    asm("shrdl %b2, %1, %0" : "+r"(low) : "r"(middle), "cI"(shift) : "cc");
    asm("shrdl %b2, %1, %0"
        : "+r"(middle)
        : "r"(static_cast<std::uint32_t>(static_cast<std::uint64_t>(value.high) >> 32)), "cI"(shift)
        : "cc");
    return static_cast<std::int64_t>(std::uint64_t{middle} << 32 | low);
}

/// One `shldl`, which sets the sign flag; the compiler's code would test again whether the shift is 32 or more.
[[gnu::always_inline]] constexpr ShiftedUpper shift_left(std::int64_t value, int shift) {
    if (std::is_constant_evaluated()) return plain::shift_left(value, shift);
    auto bits = static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) >> 32);
    bool is_below_zero = false;
    asm("shldl %b3, %2, %0" : "+r"(bits), "=@ccs"(is_below_zero) : "r"(static_cast<std::uint32_t>(value)), "cI"(shift));
    return {bits, is_below_zero};
}

[[gnu::always_inline]] inline std::uint64_t product_above_one(std::uint32_t size, std::uint32_t above) {
    std::uint32_t low = size, high = 0;
    asm("mull %2\n\taddl %3, %0\n\tadcl %3, %1" : "+&a"(low), "=&d"(high) : "rm"(above), "r"(size) : "cc");
    return std::uint64_t{high} << 32 | low;
}

/// Without loading what is in memory.
[[gnu::always_inline]] inline bool is_in_range(std::uint32_t value, std::uint32_t first, std::uint32_t count) {
    bool is_in = false;
    asm("subl %[first], %[value]\n\tcmpl %[count], %[value]"
        : [value] "+&r"(value), "=@ccb"(is_in)
        : [first] "rm"(first), [count] "rm"(count));
    return is_in;
}

[[gnu::always_inline]] inline std::int32_t rounded_quotient_8(std::int32_t a, std::int32_t b, std::uint32_t d) {
    std::int32_t quotient;
    asm("imull %[b]\n\t"
        "addl %[low], %%eax\n\t"
        "adcl %[high], %%edx\n\t"
        "shrdl $8, %%edx, %%eax\n\t"
        "shrl $8, %%edx\n\t"
        "divl %[d]"
        : "=&a"(quotient)
        : "0"(a), [b] "rm"(b), [low] "rm"(d << 7), [high] "rm"(2 * d + (d >> 25)), [d] "rm"(d)
        : "edx", "cc");
    return quotient - (1 << 25);
}

/// From the lower product's upper half on.
[[gnu::always_inline]] inline std::int64_t rounded_product_48(std::int32_t factor, const std::int32_t& low,
                                                              const std::int32_t& high) {
    std::int64_t product;
    std::int32_t kept_low, kept_high;
    asm("movl %[factor], %%eax\n\timull %[low]\n\tleal 0x8000(%%edx), %%eax\n\tcltd\n\t"
        "movl %%eax, %[kept_low]\n\tmovl %%edx, %[kept_high]\n\t"
        "movl %[factor], %%eax\n\timull %[high]\n\taddl %[kept_low], %%eax\n\tadcl %[kept_high], %%edx\n\t"
        "shrdl $16, %%edx, %%eax\n\tsarl $16, %%edx"
        : "=&A"(product), [kept_low] "=&r"(kept_low), [kept_high] "=&r"(kept_high)
        : [factor] "rm"(factor), [low] "m"(low), [high] "m"(high)
        : "cc");
    return product;
}

}  // namespace oblong::on_i386
