#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/base/input_error.h"

namespace oblong {

/// Appends an integer, lowest byte first, on any machine.
template <class Int>
void append_little_endian(std::vector<std::uint8_t>& bytes, Int number) {
    for (std::size_t byte = 0; byte < sizeof(Int); ++byte)
        bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(number) >> (8 * byte)));
}

constexpr std::uint32_t little_endian_u32(const std::uint8_t* four) {
    return std::uint32_t{four[0]} | std::uint32_t{four[1]} << 8 | std::uint32_t{four[2]} << 16 |
           std::uint32_t{four[3]} << 24;
}

/// Throws InputError naming the offset unless `is_right`.
inline void expect_at(std::size_t offset, bool is_right, const std::string& what_is_wrong) {
    if (!is_right) throw InputError("offset " + std::to_string(offset), what_is_wrong);
}

/// The same, without making a string if nothing is wrong.
inline void expect_at(std::size_t offset, bool is_right, const char* what_is_wrong) {
    if (!is_right) expect_at(offset, false, std::string(what_is_wrong));
}

/// Reads such integers in sequence. Throws InputError at the end of the bytes.
class LittleEndianReader {
  public:
    explicit LittleEndianReader(std::span<const std::uint8_t> bytes, std::size_t start = 0)
        : bytes_(bytes), at_(start) {}

    std::size_t offset() const { return at_; }
    std::size_t rest() const { return bytes_.size() - at_; }

    std::span<const std::uint8_t> take(std::size_t count) {
        if (count > rest()) fail(count);
        at_ += count;
        return bytes_.subspan(at_ - count, count);
    }
    template <class Int>
    Int next() {
        const std::uint8_t* const bytes = take(sizeof(Int)).data();
        using Bits = std::conditional_t<sizeof(Int) <= 4, std::uint32_t, std::uint64_t>;
        Bits number = 0;
        for (std::size_t i = 0; i < sizeof(Int); ++i) number |= Bits{bytes[i]} << (8 * i);
        return static_cast<Int>(number);
    }

  private:
    [[gnu::cold, gnu::noinline]] void fail(std::size_t count) const {
        expect_at(at_, false, std::to_string(rest()) + " bytes are left, expected " + std::to_string(count));
    }

    std::span<const std::uint8_t> bytes_;
    std::size_t at_;
};

}  // namespace oblong
