#pragma once

#include <memory>
#include <string>
#include <vector>

#include "game/level/load.h"
#include "game/simulation/game_level.h"

namespace oblong {

/// Where the files of a level are looked for: the arguments of load_game().
struct LevelFiles {
    std::string level, palette, assets, models;
    std::vector<std::string> game_folders = {};
};

/// A level, loaded to be played: its files, what is in them, and the part of the game that never changes.
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
