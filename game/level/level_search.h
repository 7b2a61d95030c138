#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/io/game_files.h"

namespace oblong {

/// Where levels are searched by name: as NAME.bsp in the folder of the current level, in the current folder, in its
/// maps/, in maps/ of the game's folders, and last in their pak files.
struct LevelPlaces {
    std::string beside;  ///< the file of the level that is played; empty: none
    std::vector<std::string> game_folders;
};

/// The game's folders: `named`, or if that is empty, the current folder and id1 in it (also as ID1, Id1).
std::vector<std::string> game_folders_of(const std::string& named);

/// The file of a level, or its path in a pak file (engine/io/game_files.h), as load_game() takes it; nothing if
/// there is none of that name. Throws FileError for a broken pak file.
std::optional<std::string> find_level(const std::string& name, const LevelPlaces& places);

/// The same; throws FileError where there is none.
std::string find_named_level(const std::string& name, const LevelPlaces& places);

/// What the names of drafts end with, which --watch compiles beside their sources.
inline constexpr const char* kDraftEnding = "-draft";

struct ListedLevel {
    std::string name;  ///< as "e1m1"
    std::string file;  ///< as load_game() takes it; empty: the demo level
};

struct LevelList {
    std::vector<ListedLevel> levels;    ///< the demo level, then single files, then those of pak files; of each
                                        ///< name only the one that find_level() finds
    std::vector<std::string> problems;  ///< the FileError texts of broken pak files
};

/// All levels that can be played, but for drafts.
LevelList list_levels(const LevelPlaces& places);

}  // namespace oblong
