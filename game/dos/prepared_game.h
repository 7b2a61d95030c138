#pragma once

// A level's data after loading: in the DOS build in place of LEVEL.bsp. DOS lacks the libraries to load
// models and pictures, and a 486 takes seconds to check a level. Warnings and the names of frames and skins are left
// out.
#include <algorithm>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "engine/base/little_endian.h"
#include "game/level/load.h"

namespace oblong {

// Numbers of 32 and 64 bits are stored by 7 bits a byte, the lowest first; all but the last byte have bit 7 set. Signed
// ones are stored as 2n, or -1 - 2n if negative, since most are near 0.

inline constexpr int kBits = 7;
inline constexpr std::uint8_t kGoesOn = 1 << kBits;

/// Appends the visited values.
class Writer {
  public:
    template <class Int>
    void number(const Int& value) {
        if constexpr (sizeof(Int) < sizeof(std::int32_t)) return append_little_endian(bytes, value);
        auto bits = static_cast<std::uint64_t>(value);
        if constexpr (std::is_signed_v<Int>) bits = bits << 1 ^ (value < 0 ? ~std::uint64_t{0} : 0);
        for (; bits >> kBits != 0; bits >>= kBits) bytes.push_back(static_cast<std::uint8_t>(bits | kGoesOn));
        bytes.push_back(static_cast<std::uint8_t>(bits));
    }
    std::size_t count(const auto& list) {
        number(static_cast<std::uint32_t>(list.size()));
        return list.size();
    }
    void add(std::span<const std::uint8_t> list) { bytes.insert(bytes.end(), list.begin(), list.end()); }
    std::vector<std::uint8_t> bytes;
};

/// Reads the visited values.
class Reader {
  public:
    explicit Reader(std::span<const std::uint8_t> bytes) : reader_(bytes) {}

    template <class Int>
    void number(Int& value) {
        if constexpr (sizeof(Int) < sizeof(std::int32_t)) {
            value = reader_.next<Int>();
        } else {
            std::make_unsigned_t<Int> bits = 0, part = kGoesOn;
            for (std::size_t shift = 0; (part & kGoesOn) != 0 && shift < 8 * sizeof(Int); shift += kBits) {
                part = reader_.next<std::uint8_t>();
                bits |= (part & (kGoesOn - 1)) << shift;
            }
            if constexpr (std::is_signed_v<Int>) bits = bits >> 1 ^ -(bits & 1);
            value = static_cast<Int>(bits);
        }
    }
    std::size_t count(auto& list) {
        std::uint32_t size = 0;
        number(size);
        expect_at(reader_.offset(), size <= reader_.rest(), "a list longer than the bytes left");
        list.resize(size);
        return size;
    }
    void add(std::span<std::uint8_t> list) {
        const auto from = reader_.take(list.size());
        std::copy(from.begin(), from.end(), list.begin());
    }
    void expect_end() const { expect_at(reader_.offset(), reader_.rest() == 0, "more bytes than expected"); }

  private:
    LittleEndianReader reader_;
};

/// Writes the level with its T-junctions, its hash, its colormap and its models.
std::vector<std::uint8_t> encode_prepared_game(const GameData& data);

/// Reads the same. Throws InputError for bytes that end too early, or are too many.
void decode_prepared_game(std::span<const std::uint8_t> bytes, GameData& data);

/// What DOS shows of a game: without music, icon, credits and classes.
std::vector<std::uint8_t> encode_definition(const GameDefinition& game);
/// Throws InputError as decode_prepared_game().
GameDefinition decode_definition(std::span<const std::uint8_t> bytes);

}  // namespace oblong
