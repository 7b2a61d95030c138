#pragma once

#include "engine/files/game_definition.h"
#include "engine/platform/platform.h"
#include "game/sound/game_sound.h"

namespace oblong {

/// The sounds and captions of a game's folder. Throws FileError for a caption of no sound.
OwnSounds own_sounds_of(const GameDefinition& game);

/// Gives the window the game's icon, if it has one: else the desktop knows the program's. Throws FileError.
void show_icon(const GameDefinition& game, Platform& platform);

}  // namespace oblong
