#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/files/game_files.h"

namespace oblong {

/// Where levels are looked for by their names: as NAME.bsp in the folder of the level that is played, in the current
/// folder, in maps/ there, in maps/ of the game's folders, and last in their pak files.
struct LevelPlaces {
    std::string beside;  ///< the file of the level that is played; empty: none
    std::vector<std::string> game_folders;
};

/// The game's folders: the one that is named; if none is, the current folder and id1 in it.
std::vector<std::string> game_folders_of(const std::string& named);

/// The file of a level, or its path in a pak file (engine/files/game_files.h), as load_game() takes it; nothing where
/// there is none of that name. Throws FileError for a broken pak file.
std::optional<std::string> find_level(const std::string& name, const LevelPlaces& places);

/// The same; throws FileError where there is none.
std::string find_named_level(const std::string& name, const LevelPlaces& places);

struct ListedLevel {
    std::string name;  ///< as "e1m1"
    std::string file;  ///< as load_game() takes it; empty: the demo level
};

struct LevelList {
    std::vector<ListedLevel> levels;    ///< the demo level, then those that stand alone, then those of pak files; each
                                        ///< name once, the one that find_level() finds
    std::vector<std::string> problems;  ///< broken pak files, as FileError says it
};

/// All levels that can be played.
LevelList list_levels(const LevelPlaces& places);

}  // namespace oblong
