#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/files/game_definition.h"
#include "engine/files/level_models.h"
#include "engine/files/level_sounds.h"
#include "engine/level/level.h"
#include "engine/scene/level_effects.h"
#include "engine/surface/colormap.h"
#include "engine/surface/palette.h"

namespace oblong {

/// The demo level, in the assets' folder.
inline constexpr const char* kDemoLevelFile = "demo.bsp";

/// The files that a game needs, loaded.
struct GameData {
    std::string level_file;
    std::uint64_t level_hash = 0;  ///< FNV-1a of the level file's bytes, and of the rules that it is played by
    std::uint64_t rules_hash = 0;  ///< GameDefinition::rules_hash
    Level level;
    LevelEffects effects;  ///< of the level
    Palette palette;
    Colormap colormap;
    LevelModels models;  ///< of the level
    LevelSounds sounds;  ///< of the level's own
};

/// Where the files of a level are looked for; empty names where nothing is asked for.
struct LevelFiles {
    std::string level, palette;
    std::string assets;                               ///< the museum's folder: what is nowhere else is there
    std::string models;                               ///< a folder in which models are looked for first
    std::vector<std::string> game_folders = {};       ///< of a game like Quake's
    std::shared_ptr<const GameDefinition> game = {};  ///< whose levels and rules these are; null: nobody's
};

/// Reads a level and its palette. No level: the game's first one, or the demo level of `assets`. No palette: the game's
/// for its levels; else palette.lmp in the level's folder, in gfx/ there or in the folder above, in gfx/ of the game's
/// folders or their pak files, or in `assets`. Models are looked for in progs/ of the game's folders, too. Levels may
/// be in pak files: see engine/files/game_files.h. Prints on standard error what of the level is not obeyed. Throws
/// FileError.
GameData load_game(const LevelFiles& files);

}  // namespace oblong
