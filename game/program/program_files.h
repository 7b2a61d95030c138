#pragma once

#include <memory>
#include <string>

#include "engine/platform/platform.h"
#include "engine/programs/game_definition.h"
#include "game/input/tick_input_source.h"
#include "game/level/load.h"
#include "game/options/options.h"
#include "game/program/level_watch.h"
#include "game/sound/game_sound.h"

namespace oblong {

/// The files of the level that the options name. Throws FileError if --map names no level.
LevelFiles level_files_of(const Options& options, const std::string& assets_folder);

/// The files that a program reads before it opens a window.
struct ProgramFiles {
    std::shared_ptr<const LoadedLevel> loaded;
    TickInputSource input;                        ///< of the first game
    std::shared_ptr<LevelWatch> watch = nullptr;  ///< recompiles `loaded`, if not null
};

/// Reads the level, and the demo that the options name, and checks that a recording can be written. Throws FileError.
ProgramFiles load_program_files(const Options& options, const LevelFiles& level);
/// The same with the level that the options name.
ProgramFiles load_program_files(const Options& options, const std::string& assets_folder);

/// The files of later levels: those of the first one, except its palette.
LevelFiles files_of_game(const LoadedLevel& first, const Options& options);

/// The name of a game for the options file and its saves, from its folder; without a folder: kQuake. ASCII letters,
/// digits, ".", "-" and "_", which others become; with a number if the folder's name is not ASCII.
std::string game_name(const std::string& folder);

/// The folder of a game's saves, separate for each game, so that no title offers walks of another game.
std::string saves_folder_of(const Options& options);

/// The sounds and captions of a game's folder. Throws FileError for a caption of an unknown sound.
OwnSounds own_sounds_of(const GameDefinition& game);

/// Sets the window's icon to the game's, if it has one. Throws FileError.
void show_icon(const GameDefinition& game, Platform& platform);

}  // namespace oblong
