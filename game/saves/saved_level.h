#pragma once

#include <string>

#include "game/level/load.h"
#include "game/saves/saved_game.h"

namespace oblong {

/// A loaded level, as a save stores it.
SavedLevel saved_level_of(const LoadedLevel& loaded);

/// The files to load a saved level from. The demo level is taken from `own`, the program's files, in case the program
/// has moved; so are palette and models if the named ones are gone.
LevelFiles files_of(const SavedLevel& saved, const LevelFiles& own);

/// A warning to the player if a level is shown in other colours or without some of its models; else empty.
std::string what_is_gone(const SavedLevel& saved, const SavedLevel& loaded);

}  // namespace oblong
