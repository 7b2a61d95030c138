#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/level/level.h"
#include "engine/models/level_models.h"
#include "engine/programs/game_definition.h"
#include "engine/scene/level_effects.h"
#include "engine/sound/sound_file.h"
#include "engine/surface/colormap.h"
#include "engine/surface/palette.h"
#include "game/simulation/game_level.h"

namespace oblong {

/// The demo level, in the assets' folder.
inline constexpr const char* kDemoLevelFile = "demo.bsp";

/// The files that a game needs, loaded.
struct GameData {
    std::string level_file;
    std::uint64_t level_hash = 0;  ///< FNV-1a of the level file's bytes, XOR rules_hash
    std::uint64_t rules_hash = 0;  ///< GameDefinition::rules_hash
    Level level;
    LevelEffects effects;  ///< of the level
    Palette palette;
    Colormap colormap;
    LevelModels models;  ///< of the level
    LevelSounds sounds;  ///< those that the level names
};

struct LevelFiles;

/// Reads a level and its palette. No level: the game's first one, or the demo level of `assets`. No palette: the game's
/// for its levels; else palette.lmp in the level's folder, in gfx/ there or in the folder above, in gfx/ of the game's
/// folders or their pak files, or in `assets`. Models are also searched in progs/ of the game's folders. Levels may be
/// in pak files: see engine/io/game_files.h. Prints on standard error the parts of the level that are ignored.
/// Throws FileError.
GameData load_game(const LevelFiles& files);

/// Where the files of a level are searched, and what reads them. Empty names: the defaults of load_game().
struct LevelFiles {
    std::string level, palette;
    std::string assets;                                           ///< the program's own data, searched last
    std::string models;                                           ///< a folder in which models are looked for first
    std::vector<std::string> game_folders = {};                   ///< of a game like Quake's
    std::shared_ptr<const GameDefinition> game = {};              ///< whose levels and rules these are; null: none
    std::function<GameData(const LevelFiles&)> load = load_game;  ///< another where a build has prepared the game
};

/// A level, loaded to be played: its files, their contents, and the part of the game that never changes.
struct LoadedLevel {
    /// Throws FileError.
    explicit LoadedLevel(const LevelFiles& named);
    LoadedLevel(const LoadedLevel&) = delete;  // `level` points into `data`
    LoadedLevel& operator=(const LoadedLevel&) = delete;

    const LevelFiles files;
    const GameData data;
    const GameLevel level;
    /// From an entity to the void, where the level leaks: of the .pts file that its compiler has left beside it. Shown
    /// through walls, too.
    const std::vector<Position> leak_path;
};

}  // namespace oblong
