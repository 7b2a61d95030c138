#pragma once

#include "game/load.h"
#include "game/saves/saved_game.h"

namespace oblong {

/// `data.level_file` as a place that does not depend on the current folder, and the hashes.
SavedLevel saved_level_of(const GameData& data, const GameLevel& level);

}  // namespace oblong
