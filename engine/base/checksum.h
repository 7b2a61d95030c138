#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace oblong {

/// 64-bit FNV-1a (Fowler, Noll and Vo), the same on every machine. Inputs that differ in one byte have different
/// hashes; it does not protect against forgery.
class Fnv1a {
  public:
    constexpr void add(std::uint8_t byte) { value_ = (value_ ^ byte) * kPowers[1]; }
    constexpr void add(std::span<const std::uint8_t> bytes) {
        for (const std::uint8_t byte : bytes) add(byte);
    }
    /// Eight bytes, the lowest first. The highest ones are mostly zero, and a product with a power of the prime adds
    /// them all: a third of the time on a 486.
    constexpr void add_number(std::uint64_t number) {
        std::size_t left = 8;
        for (; number != 0; number >>= 8, --left) add(static_cast<std::uint8_t>(number));
        value_ *= kPowers[left];
    }
    constexpr std::uint64_t value() const { return value_; }

  private:
    static constexpr std::array<std::uint64_t, 9> kPowers = [] {
        std::array<std::uint64_t, 9> powers{1};
        for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 1'099'511'628'211u;
        return powers;
    }();

    std::uint64_t value_ = 14'695'981'039'346'656'037u;
};

constexpr std::uint64_t fnv1a_of(std::span<const std::uint8_t> bytes) {
    Fnv1a hash;
    hash.add(bytes);
    return hash.value();
}

/// CRC-32 as in zlib and PNG (ISO 3309). `before` is the sum of the bytes before these.
constexpr std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t before = 0) {
    std::uint32_t crc = ~before;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320 : crc >> 1;
    }
    return ~crc;
}

}  // namespace oblong
