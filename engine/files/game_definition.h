#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// A class of entities that a game defines: another class of the engine's (engine/level/entity_classes.h), with values
/// of keys of its own where an entity has none.
struct OwnClass {
    std::string is;
    std::vector<std::pair<std::string, std::string>> values;
};

/// What makes a folder a game: its file game.json.
struct GameDefinition {
    std::string folder;  ///< that everything is in
    std::string title;
    std::vector<std::string> levels;              ///< their names, in the order in which they are played; one or more
    std::string palette, music, demo, icon;       ///< paths of files, empty: none. Music and demo are the title's; a
                                                  ///< demo need not be there. The icon is the window's
    std::string credits;                          ///< what its page says first
    std::map<std::string, std::string> captions;  ///< by the names of sounds' files, and by these:
    std::map<std::string, OwnClass> classes;      ///< by their names
    std::uint64_t rules_hash = 0;                 ///< of the classes; 0: there are none
};

/// What game.json may call otherwise.
inline constexpr const char *kOneLens = "a lens", *kLenses = "lenses";
/// Its caption for one of those; else what it is called in the museum.
std::string own_words(const GameDefinition& game, const char* words);

/// A member that game.json may have.
struct GameMember {
    std::string_view name, does;
};
std::vector<GameMember> game_members();

inline constexpr const char* kGameFile = "game.json";

/// Whether a folder has a game.json.
bool is_game_folder(const std::string& folder);

/// Reads a folder's game.json. Throws FileError that names the file and the place in it: for what is no JSON, members
/// that there are not or that are of another type, classes that stand for none of the engine's, paths that leave the
/// folder, files that are not there. Levels need not be there yet: see check_levels().
GameDefinition read_game_definition(const std::string& folder);

/// The file of one of its levels: maps/NAME.bsp in its folder, or NAME.bsp; empty where it has no such file.
std::string level_file_of(const GameDefinition& game, const std::string& level);

/// Throws FileError for a level that has no file.
void check_levels(const GameDefinition& game);

/// The level that is played after the one in `file`; empty after the last, and where `file` is none of its levels.
std::string level_after(const GameDefinition& game, const std::string& file);

/// Replaces the game's own classes by the classes that they stand for. Keys that an entity lacks take the values of its
/// own class.
void apply_classes(const GameDefinition& game, std::vector<Entity>& entities);

}  // namespace oblong
