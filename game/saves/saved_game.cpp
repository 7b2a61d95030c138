#include "game/saves/saved_game.h"

#include <algorithm>
#include <string_view>

#include "engine/base/fnv.h"
#include "engine/base/little_endian.h"
#include "game/saves/state_bytes.h"
#include "game/simulation/state_check.h"

namespace oblong {
namespace {

constexpr std::string_view kMagic = "OBLGSAVE";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kVersionAt = 8, kSizeAt = 12, kHeaderBytes = 16, kHashBytes = 8, kLongestName = 4096;

void append_picture(std::vector<std::uint8_t>& bytes, const Thumbnail& picture) {
    for (const Rgb8 colour : picture.palette.colours)
        bytes.insert(bytes.end(), {colour.red, colour.green, colour.blue});
    bytes.insert(bytes.end(), picture.pixels.begin(), picture.pixels.end());
}

Thumbnail read_picture(LittleEndianReader& reader) {
    Thumbnail picture;
    picture.palette = read_palette(reader.take(3 * picture.palette.colours.size()));
    const auto pixels = reader.take(picture.pixels.size());
    std::copy(pixels.begin(), pixels.end(), picture.pixels.begin());
    return picture;
}

SavedLevel read_level(LittleEndianReader& reader) {
    SavedLevel level;
    const auto name = reader.take(reader.next<std::uint16_t>());
    level.name.assign(name.begin(), name.end());
    level.file_hash = reader.next<std::uint64_t>();
    level.start_hash = reader.next<std::uint64_t>();
    return level;
}

// That the file is whole and as it was written; returns what is between header and checksum.
LittleEndianReader checked(std::span<const std::uint8_t> bytes) {
    expect_at(0, bytes.size() >= kHeaderBytes + kHashBytes,
              "the file has " + std::to_string(bytes.size()) + " bytes, expected a saved game");
    expect_at(0, std::equal(kMagic.begin(), kMagic.end(), bytes.begin()), "no saved game: expected 'OBLGSAVE'");
    LittleEndianReader header(bytes, kVersionAt);
    const auto version = header.next<std::uint32_t>();
    expect_at(kVersionAt, version == kVersion,
              "saved by another version of the game (" + std::to_string(version) + "), expected 1");
    const auto size = header.next<std::uint32_t>();
    expect_at(kSizeAt, size == bytes.size(),
              "the file has " + std::to_string(bytes.size()) + " bytes, expected the " + std::to_string(size) +
                  " that were saved");
    const std::size_t end = bytes.size() - kHashBytes;
    expect_at(end, LittleEndianReader(bytes, end).next<std::uint64_t>() == fnv1a_of(bytes.first(end)),
              "the checksum is another, expected an unaltered file");
    return LittleEndianReader(bytes.first(end), kHeaderBytes);
}

}  // namespace

std::vector<std::uint8_t> encode_save(const SavedGame& game) {
    std::vector<std::uint8_t> bytes(kMagic.begin(), kMagic.end());
    append_little_endian(bytes, kVersion);
    append_little_endian(bytes, std::uint32_t{0});  // the size: below
    append_little_endian(bytes, state_layout());
    const std::string name = game.level.name.substr(0, kLongestName);
    append_little_endian(bytes, static_cast<std::uint16_t>(name.size()));
    bytes.insert(bytes.end(), name.begin(), name.end());
    append_little_endian(bytes, game.level.file_hash);
    append_little_endian(bytes, game.level.start_hash);
    append_picture(bytes, game.picture);
    append_little_endian(bytes, hash_of(game.state));
    append_state(bytes, game.state);
    std::vector<std::uint8_t> size;
    append_little_endian(size, static_cast<std::uint32_t>(bytes.size() + kHashBytes));
    std::copy(size.begin(), size.end(), bytes.begin() + kSizeAt);
    append_little_endian(bytes, fnv1a_of(bytes));
    return bytes;
}

SavedGame decode_save(std::span<const std::uint8_t> bytes) {
    LittleEndianReader reader = checked(bytes);
    expect_at(kHeaderBytes, reader.next<std::uint64_t>() == state_layout(),
              "saved by another version of the game, expected a state of this one's fields");
    SavedGame game;
    game.level = read_level(reader);
    game.picture = read_picture(reader);
    const std::size_t hash_at = reader.offset();
    const auto state_hash = reader.next<std::uint64_t>();
    game.state = read_state(reader);
    expect_at(reader.offset(), reader.rest() == 0,
              std::to_string(reader.rest()) + " bytes follow the state, expected none");
    expect_at(hash_at, hash_of(game.state) == state_hash, "the state has another hash, expected the one saved");
    return game;
}

void check_level(const SavedGame& game, std::uint64_t level_hash, const GameLevel& level) {
    if (game.level.file_hash != level_hash)
        throw InputError("level", "saved in another level or another version of it, expected this one");
    if (game.level.start_hash != hash_of(start_of(level)) || !is_consistent(level, game.state))
        throw InputError("state", "not one of this level, expected one saved by this version of the game");
}

}  // namespace oblong
