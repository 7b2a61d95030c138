#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "game/saves/thumbnail.h"
#include "game/simulation/game_level.h"
#include "game/simulation/state.h"

namespace oblong {

/// The level in which a game was saved.
struct SavedLevel {
    std::string name;              ///< what load_game() takes; at most 4,096 bytes
    std::uint64_t file_hash = 0;   ///< GameData::level_hash
    std::uint64_t start_hash = 0;  ///< of start_of(level): the level as this version of the game reads it

    bool operator==(const SavedLevel&) const = default;
};

/// A game that can be gone on with. Its time is state.tick.
struct SavedGame {
    SavedLevel level;
    GameState state;
    Thumbnail picture;

    bool operator==(const SavedGame&) const = default;
};

/// The file, little-endian: "OBLGSAVE", version (u32: 1), its whole size (u32), a hash of the kinds of a state's fields
/// (u64: state_layout()), the level's name (u16 and so many bytes), file hash (u64) and start hash (u64), the picture
/// (palette: 256 times red, green, blue; then 80x50 indices), the hash of the state (u64), the state (append_state()),
/// FNV-1a of all bytes before (u64).
std::vector<std::uint8_t> encode_save(const SavedGame& game);

/// Parses such bytes. Throws InputError unless they are a whole and unaltered save of this version of the game.
SavedGame decode_save(std::span<const std::uint8_t> bytes);

/// Throws InputError unless the game was saved in this very level and can be gone on with there.
void check_level(const SavedGame& game, std::uint64_t level_hash, const GameLevel& level);

}  // namespace oblong
