#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace oblong::test {

/// MD5 (RFC 1321): what a FLAC file says of its samples.
inline std::array<std::uint8_t, 16> md5(std::vector<std::uint8_t> bytes) {
    const std::uint64_t bits = bytes.size() * 8;
    bytes.push_back(0x80);
    while (bytes.size() % 64 != 56) bytes.push_back(0);
    for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<std::uint8_t>(bits >> 8 * i));
    constexpr int kTurns[4][4] = {{7, 12, 17, 22}, {5, 9, 14, 20}, {4, 11, 16, 23}, {6, 10, 15, 21}};
    std::array<std::uint32_t, 4> sum{0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476};
    for (std::size_t block = 0; block < bytes.size(); block += 64) {
        auto [a, b, c, d] = sum;
        for (std::uint32_t i = 0; i < 64; ++i) {
            const std::uint32_t mixes[4] = {(b & c) | (~b & d), (d & b) | (~d & c), b ^ c ^ d, c ^ (b | ~d)};
            const std::uint32_t words[4] = {i, 5 * i + 1, 3 * i + 5, 7 * i};
            std::uint32_t word = 0;
            for (std::size_t k = 4; k-- > 0;) word = word << 8 | bytes[block + words[i / 16] % 16 * 4 + k];
            const auto sine = static_cast<std::uint32_t>(std::floor(std::abs(std::sin(i + 1.0)) * 4294967296.0));
            const std::uint32_t turned = std::rotl(a + mixes[i / 16] + sine + word, kTurns[i / 16][i % 4]);
            a = d, d = c, c = b, b += turned;
        }
        sum[0] += a, sum[1] += b, sum[2] += c, sum[3] += d;
    }
    std::array<std::uint8_t, 16> result{};
    for (std::size_t i = 0; i < 16; ++i) result[i] = static_cast<std::uint8_t>(sum[i / 4] >> 8 * (i % 4));
    return result;
}

}  // namespace oblong::test
