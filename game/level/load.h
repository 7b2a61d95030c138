#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/files/level_models.h"
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
    std::uint64_t level_hash = 0;  ///< FNV-1a of the level file's bytes
    Level level;
    LevelEffects effects;  ///< of the level
    Palette palette;
    Colormap colormap;
    LevelModels models;  ///< of the level
};

/// Reads the level and its palette; empty names: the demo level of `assets_folder`, and the palette.lmp in the level's
/// folder, in gfx/ there or in the folder above, in gfx/ of the game's folders or their pak files, or in
/// `assets_folder`. Models are looked for in `models_folder` too, if it is not empty, and in progs/ of the game's.
/// Levels may be in pak files: see engine/files/game_files.h. Prints on standard error what of the level is not obeyed.
/// Throws FileError.
GameData load_game(const std::string& level_file, const std::string& palette_file, const std::string& assets_folder,
                   const std::string& models_folder = "", const std::vector<std::string>& game_folders = {});

}  // namespace oblong
