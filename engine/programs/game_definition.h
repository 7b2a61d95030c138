#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// A class of entities that a game defines: a class of the engine (engine/level/entity_classes.h) with its own default
/// values of keys.
struct OwnClass {
    std::string is, does;  ///< does: for readers
    std::vector<std::pair<std::string, std::string>> values;
};

/// The file game.json, which makes a folder a game.
struct GameDefinition {
    std::string folder;  ///< of the game
    std::string title;
    std::vector<std::string> levels;              ///< their names, in the order in which they are played; one or more
    std::string palette, music, demo, icon;       ///< paths of files, empty: none. Music and demo are the title's; a
                                                  ///< demo need not be there. The icon is the window's
    std::string credits;                          ///< the first text of the credits page
    std::map<std::string, std::string> captions;  ///< by the names of sound files, and the museum's own words
    std::map<std::string, OwnClass> classes;      ///< by name
    bool has_gallery = true, has_lab = true;      ///< as the museum: other games name what they want
    bool has_counts = false;                      ///< a line with what the player has taken
    std::uint64_t rules_hash = 0;                 ///< of the classes; 0: there are none
};

/// The museum's words that a caption of game.json may replace.
inline constexpr const char *kOneLens = "a lens", *kLenses = "lenses", *kYouNeed = "You need ",
                            *kReachedEnd = "You have reached the end.";
bool is_replaceable(const std::string& words);
/// The game's caption for one of those; else the words themselves.
std::string own_words(const GameDefinition& game, const std::string& words);

/// A member that game.json may have.
struct GameMember {
    std::string_view name, does;
};
std::vector<GameMember> game_members();

inline constexpr const char* kGameFile = "game.json";

/// Whether a folder has a game.json.
bool is_game_folder(const std::string& folder);

/// Reads a folder's game.json. Throws FileError that names the file and the place in it: for invalid JSON, unknown
/// members or members of another type, classes based on an unknown class, paths that leave the folder, missing files.
/// Levels may be missing: they are read when they are played.
GameDefinition read_game_definition(const std::string& folder);

/// The file of a level of the game: maps/NAME.bsp in its folder, or NAME.bsp if there is only that.
std::string level_file_of(const GameDefinition& game, const std::string& level);

/// The next level after the one in `file`; empty after the last, and if `file` is not a level of the game.
std::string level_after(const GameDefinition& game, const std::string& file);

/// Replaces the game's own classes by the classes that they stand for. Keys that an entity lacks take the values of its
/// own class.
void apply_classes(const GameDefinition& game, std::vector<Entity>& entities);

}  // namespace oblong
