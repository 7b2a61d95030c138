#include "game/level/load.h"

#include <filesystem>
#include <utility>

#include "engine/base/fnv.h"
#include "engine/effects/things.h"
#include "engine/files/arguments.h"
#include "engine/files/game_files.h"
#include "engine/level/bsp_read.h"
#include "game/simulation/entity_keys.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGamePalette = "gfx/palette.lmp";

std::string find_palette(const fs::path& level_folder, const GameFiles& game, const fs::path& assets) {
    for (const fs::path& file :
         {level_folder / "palette.lmp", level_folder / kGamePalette, level_folder / ".." / kGamePalette})
        if (fs::exists(file)) return file.string();
    if (level_folder == assets) return (assets / "palette.lmp").string();
    return game.find(kGamePalette).value_or((assets / "palette.lmp").string());
}

// Those of the game, and before them the folder of the pak file that the level is in.
GameFiles game_files_of(const std::string& level_file, std::vector<std::string> folders) {
    if (const auto inside = path_in_pak(level_file))
        folders.insert(folders.begin(), (fs::path(inside->pak).parent_path() / ".").lexically_normal().string());
    return GameFiles(std::move(folders));
}

// What is not in the level when one plays alone at normal skill shows no model either.
void remove_left_out(const Level& level, LevelModels& models) {
    std::erase_if(models.models, [&](const LevelModel& model) { return is_left_out(level.entities[model.entity]); });
}

}  // namespace

GameData load_game(const std::string& level_file, const std::string& palette_file, const std::string& assets_folder,
                   const std::string& models_folder, const std::vector<std::string>& game_folders) {
    GameData data;
    data.level_file = level_file.empty() ? (fs::path(assets_folder) / kDemoLevelFile).string() : level_file;
    const GameFiles game = game_files_of(data.level_file, game_folders);
    data.level = read_parsed_game_file(data.level_file, [&](std::span<const std::uint8_t> bytes) {
        data.level_hash = fnv1a_of(bytes);
        return read_bsp(bytes);
    });
    data.effects = read_level_effects(data.level);
    print_warnings("oblong", data.level_file, data.effects.warnings);
    print_warnings("oblong", data.level_file, read_things(data.level).warnings);
    const std::string palette = palette_file.empty()
                                    ? find_palette(fs::path(data.level_file).parent_path(), game, assets_folder)
                                    : palette_file;
    data.palette = read_parsed_game_file(palette, read_palette);
    data.colormap = make_colormap(data.palette);
    data.models = read_level_models(data.level, data.palette,
                                    {data.level_file, models_folder, assets_folder, game.has_paks() ? &game : nullptr});
    remove_left_out(data.level, data.models);
    print_warnings("oblong", data.level_file, data.models.warnings);
    return data;
}

}  // namespace oblong
