#pragma once

#include "game/level/load.h"
#include "game/simulation/game_level.h"

namespace oblong {

/// A level, loaded to be played: its files, their contents, and the part of the game that never changes.
struct LoadedLevel {
    /// Throws FileError.
    explicit LoadedLevel(const LevelFiles& named);
    LoadedLevel(const LoadedLevel&) = delete;  // `level` points into `data`
    LoadedLevel& operator=(const LoadedLevel&) = delete;

    const LevelFiles files;
    const GameData data;
    const GameLevel level;
};

}  // namespace oblong
