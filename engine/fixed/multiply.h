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

}  // namespace oblong
