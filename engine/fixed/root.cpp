#include "engine/fixed/root.h"

#include <array>
#include <bit>

#include "engine/base/table.h"
#include "engine/fixed/native/native.h"

namespace oblong {

namespace {

/// value = root^2 + remainder, 0 <= remainder <= 2 root.
struct Root {
    std::uint64_t root = 0, remainder = 0;
};

/// Roots of 64 * 256, 65 * 256, ... 255 * 256, at most one below those of all numbers with the same high byte.
constexpr auto kRootsOfHighByte = [] {
    std::array<std::uint8_t, 192> table{};
    std::uint32_t root = 128;
    for (std::uint32_t i = 0; i < 192; ++i) {
        while ((root + 1) * (root + 1) <= (i + 64) * 256) ++root;
        table[i] = static_cast<std::uint8_t>(root);
    }
    return table;
}();

/// 2^30 / sqrt(m) in the middle of each 256th of m from 1/4 to 1; relative error at most 2^-8.
constexpr auto kReciprocalRootsOfMiddles = [] {
    std::array<std::uint32_t, 192> table{};
    std::uint64_t root = std::uint64_t{1} << 31;  // entries fall: each search continues from the last
    for (std::size_t i = 0; i < 192; ++i) {
        const std::uint64_t middle_9 = 2 * (i + 64) + 1;
        // root^2 m <= 2^60, with 16 bits of the root.
        while ((root >> 15) * (root >> 15) * middle_9 > std::uint64_t{1} << 39) root -= std::uint64_t{1} << 15;
        table[i] = static_cast<std::uint32_t>(root);
    }
    return table;
}();

/// A Newton step r (3 - m r^2) / 2; m has 32 fraction bits, r 30. It is never above the root, and r below 2 keeps all
/// within 32 bits.
std::uint32_t newton_step(std::uint32_t m_32, std::uint32_t r_30) {
    const auto square_30 = static_cast<std::uint32_t>(native::product_to_64(r_30, r_30) >> 30);
    const auto share_30 = static_cast<std::uint32_t>(native::product_to_64(m_32, square_30) >> 32);
    return static_cast<std::uint32_t>(native::product_to_64(r_30, (3u << 30) - share_30) >> 31);
}

/// The root of a number from 2^14 to 2^16 - 1.
Root root_of_16_bits(std::uint32_t value) {
    std::uint32_t root = kRootsOfHighByte[(value >> 8) - 64];
    if ((root + 1) * (root + 1) <= value) ++root;
    return {root, value - root * root};
}

/// The root of high * 4^bits + next * 2^bits + last from the root of `high`, whose highest or second bit is set: as in
/// long division, the next digits are the remainder over twice the root, at most one too great. The remainder of a
/// 64-bit root has 65 bits and is truncated.
Root refine(Root high, std::uint64_t next, std::uint64_t last, int bits) {
    const std::uint64_t half_numerator = (high.remainder << (bits - 1)) + (next >> 1);
    std::uint64_t digits = half_numerator / high.root;
    std::uint64_t rest = 2 * (half_numerator % high.root) + (next & 1);
    if (digits >> bits != 0) {
        --digits;
        rest += 2 * high.root;
    }
    const std::uint64_t root = (high.root << bits) + digits;
    const std::uint64_t remainder = (rest << bits) + last - digits * digits;
    const bool is_too_great = rest >> 32 == 0 && (rest << bits) + last < digits * digits;
    return is_too_great ? Root{root - 1, remainder + 2 * root - 1} : Root{root, remainder};
}

/// The root of a number from 2^30 to 2^32 - 1.
Root root_of_32_bits(std::uint64_t value) {
    return refine(root_of_16_bits(static_cast<std::uint32_t>(value >> 16)), (value >> 8) & 0xff, value & 0xff, 8);
}

/// The root of a number from 2^62 to 2^64 - 1.
Root root_of_64_bits(std::uint64_t value) {
    return refine(root_of_32_bits(value >> 32), (value >> 16) & 0xffff, value & 0xffff, 16);
}

}  // namespace

std::uint32_t integer_root(std::uint64_t value) {
    if (value == 0) return 0;
    const int even_shift = std::countl_zero(value) & ~1;
    const bool is_short = even_shift >= 32;
    const Root scaled = is_short ? root_of_32_bits(value << (even_shift - 32)) : root_of_64_bits(value << even_shift);
    return static_cast<std::uint32_t>(scaled.root >> ((is_short ? even_shift - 32 : even_shift) / 2));
}

ReciprocalRoot reciprocal_root(std::uint64_t value) {
    const int even_shift = std::countl_zero(value) & ~1;
    const auto m_32 = static_cast<std::uint32_t>((value << even_shift) >> 32);  // at least 1/4
    const std::uint32_t seed = item(kReciprocalRootsOfMiddles, (m_32 >> 24) - 64);
    return {newton_step(m_32, newton_step(m_32, seed)), 32 - even_shift / 2};
}

std::uint64_t integer_root(Uint128 value) {
    if (value.high == 0) return integer_root(value.low);
    const int even_shift = std::countl_zero(value.high) & ~1;
    const std::uint64_t from_low = even_shift == 0 ? 0 : value.low >> (64 - even_shift);
    const std::uint64_t high = (value.high << even_shift) | from_low, low = value.low << even_shift;
    return refine(root_of_64_bits(high), low >> 32, low & 0xffffffff, 32).root >> (even_shift / 2);
}

}  // namespace oblong
