#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/base/little_endian.h"
#include "engine/base/table.h"
#include "engine/surface/palette.h"
#include "engine/view/screen.h"
#include "game/level/load.h"
#include "game/simulation/game_level.h"
#include "game/simulation/items.h"
#include "game/simulation/state.h"

namespace oblong {

/// A small picture of the view at the moment of a save, in the colours shown.
struct Thumbnail {
    static constexpr std::int32_t kWidth_px = 80, kHeight_px = 50;

    std::array<Rgb8, as_size(kWidth_px) * kHeight_px> pixels{};  ///< row by row

    bool operator==(const Thumbnail&) const = default;
};

/// Scales a picture of any mode down: each pixel is the mean of those that it covers.
Thumbnail make_thumbnail(Framebuffer picture, const Palette& palette);

/// The level of a saved game and how it was shown: load_game()'s arguments, as paths that do not depend on the current
/// folder. A name has at most 4,096 bytes; empty: load_game()'s default.
struct SavedLevel {
    std::string name, palette, models;
    std::vector<std::string> game_folders;
    std::uint64_t file_hash = 0;     ///< GameData::level_hash
    std::uint64_t start_hash = 0;    ///< of start_of(level), which depends on the version of the game
    std::uint64_t palette_hash = 0;  ///< FNV-1a of the red, green, blue of its colours
    std::uint32_t model_count = 0;   ///< of the level's models that were found

    bool operator==(const SavedLevel&) const = default;
};

/// A saved game that can be continued. Its time is state.tick.
struct SavedGame {
    SavedLevel level;
    ItemCount lenses;  ///< count_items(), readable without loading the level
    GameState state;
    Thumbnail picture;

    bool operator==(const SavedGame&) const = default;
};

/// The parts of a saved game for lists: all but its state.
struct SaveHead {
    SavedLevel level;
    ItemCount lenses;
    Thumbnail picture;
    std::int64_t tick = 0;
    std::uint64_t checksum = 0;  ///< of the whole file; identifies the save

    bool operator==(const SaveHead&) const = default;
};

/// The file, little-endian: "OBLGSAVE", version (u32: 2), its whole size (u32), a hash of the kinds of a state's fields
/// (u64: state_layout()), names of level, palette, models (each a length (u16) and its bytes), number of game folders
/// (u16) and their names, hashes of file, start and palette (u64 each), models (u32), lenses taken and in all (i32
/// each), the picture (80x50 times red, green, blue), the hash of the state (u64), the state (append_state()), FNV-1a
/// of all bytes before (u64).
std::vector<std::uint8_t> encode_save(const SavedGame& game);

/// The error of a whole save of another version starts with this.
inline constexpr const char* kOtherVersion = "saved by another version of the game";

/// Parse such a file. Throw InputError unless they are a whole and unaltered save of this version of the game.
SavedGame decode_save(std::span<const std::uint8_t> bytes);
SaveHead decode_save_head(std::span<const std::uint8_t> bytes);

/// Throws InputError unless the game was saved in this level and can be continued in it.
void check_level(const SavedGame& game, std::uint64_t level_hash, const GameLevel& level);

/// The fields of a state as bytes, in the order of visit_fields() (game/simulation/state.h): each number in its
/// own width, each list after its length (u32).
void append_state(std::vector<std::uint8_t>& bytes, const GameState& state);

/// Reads such fields. Throws InputError if they end early, or for an impossible list or bool; find_inconsistency()
/// checks the state against a level.
GameState read_state(LittleEndianReader& reader);

/// A hash of the kinds of all fields. It differs if a build's state has other fields.
std::uint64_t state_layout();

/// A loaded level, as a save stores it.
SavedLevel saved_level_of(const LoadedLevel& loaded);

/// The files to load a saved level from. The demo level is taken from `own`, the program's files, in case the program
/// has moved; so are palette and models if the named ones are gone.
LevelFiles files_of(const SavedLevel& saved, const LevelFiles& own);

/// A warning to the player if a level is shown in other colours or without some of its models; else empty.
std::string what_is_gone(const SavedLevel& saved, const SavedLevel& loaded);

}  // namespace oblong
