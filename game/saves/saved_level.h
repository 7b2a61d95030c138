#pragma once

#include <string>

#include "game/level/loaded_level.h"
#include "game/saves/saved_game.h"

namespace oblong {

/// A level that is loaded, as a save keeps it.
SavedLevel saved_level_of(const LoadedLevel& loaded);

/// The files to load a saved level from. The demo level is taken from `own`, the program's files, should the program
/// have moved since; so are palette and models where those that are named are gone.
LevelFiles files_of(const SavedLevel& saved, const LevelFiles& own);

/// What a player has to know where a level is shown in other colours or without models that it had; else empty.
std::string what_is_gone(const SavedLevel& saved, const SavedLevel& loaded);

}  // namespace oblong
