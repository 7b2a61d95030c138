#pragma once

#include <cstdint>
#include <type_traits>

// Exact products of two numbers of 32 bits: one instruction on a processor of 32 bits. A compiler that sees a factor as
// half of a 64-bit number multiplies the whole number instead.

namespace oblong {

constexpr std::int64_t product_to_64(std::int32_t a, std::int32_t b) {
#if defined(__i386__)
    if (!std::is_constant_evaluated()) {
        std::int64_t product;
        asm("imull %2" : "=A"(product) : "%a"(a), "rm"(b) : "cc");
        return product;
    }
#endif
    return std::int64_t{a} * b;
}

constexpr std::uint64_t product_to_64(std::uint32_t a, std::uint32_t b) {
#if defined(__i386__)
    if (!std::is_constant_evaluated()) {
        std::uint64_t product;
        asm("mull %2" : "=A"(product) : "%a"(a), "rm"(b) : "cc");
        return product;
    }
#endif
    return std::uint64_t{a} * b;
}

/// value + step * count modulo 2^64.
[[gnu::always_inline]] constexpr std::uint64_t wrapping_sum(std::uint64_t value, std::uint64_t step,
                                                            std::uint32_t count) {
#if defined(__i386__)
    if (!std::is_constant_evaluated()) {
        const std::uint32_t upper = static_cast<std::uint32_t>(step >> 32) * count;
        std::uint32_t low = static_cast<std::uint32_t>(step), high = 0;
        asm("mull %[count]\n\taddl %[upper], %1\n\taddl %[value_low], %0\n\tadcl %[value_high], %1"
            : "+&a"(low), "=&d"(high)
            : [count] "rm"(count), [upper] "rm"(upper), [value_low] "rm"(static_cast<std::uint32_t>(value)),
              [value_high] "rm"(static_cast<std::uint32_t>(value >> 32))
            : "cc");
        return std::uint64_t{high} << 32 | low;
    }
#endif
    return value + step * count;
}

}  // namespace oblong
