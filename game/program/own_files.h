#pragma once

#include "engine/files/game_definition.h"
#include "engine/platform/platform.h"
#include "game/sound/game_sound.h"

namespace oblong {

/// The sounds and captions of a game's folder. Throws FileError for a caption of an unknown sound.
OwnSounds own_sounds_of(const GameDefinition& game);

/// Sets the window's icon to the game's, if it has one. Throws FileError.
void show_icon(const GameDefinition& game, Platform& platform);

}  // namespace oblong
