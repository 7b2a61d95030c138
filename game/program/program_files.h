#pragma once

#include <memory>
#include <string>

#include "game/input/tick_input_source.h"
#include "game/level/loaded_level.h"
#include "game/options/options.h"
#include "game/program/map_watch.h"

namespace oblong {

/// The files of the level that the options name. Throws FileError where --map names none.
LevelFiles level_files_of(const Options& options, const std::string& assets_folder);

/// What a program reads before it opens a window.
struct ProgramFiles {
    std::string assets_folder;
    std::shared_ptr<const LoadedLevel> loaded;
    TickInputSource input;                      ///< of the first game in it
    std::shared_ptr<MapWatch> watch = nullptr;  ///< makes `loaded` anew, if not null
};

/// Reads the level and the demo that the options name, and checks that what they record can be written. Throws
/// FileError.
ProgramFiles load_program_files(const Options& options, const std::string& assets_folder);

/// The files of later levels: those that the first one was loaded with, but for its palette.
LevelFiles files_of_game(const LoadedLevel& first, const Options& options);

/// The name of a game, by its folder, as a word of the options file; without a folder: kQuake.
std::string game_name(const std::string& folder);

/// A game's own walks are in a folder of its own: the title of no other offers them.
std::string saves_folder_of(const Options& options);

}  // namespace oblong
