#include "game/level/load.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "engine/base/checksum.h"
#include "engine/effects/things.h"
#include "engine/io/game_files.h"
#include "engine/level/bsp_read.h"
#include "engine/programs/arguments.h"
#include "game/simulation/entity_specs.h"

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

// The game's folders, after the folder of the pak file that the level is in.
GameFiles game_files_of(const std::string& level_file, std::vector<std::string> folders) {
    if (const auto inside = path_in_pak(level_file))
        folders.insert(folders.begin(), (fs::path(inside->pak).parent_path() / ".").lexically_normal().string());
    return GameFiles(std::move(folders));
}

// Entities that are not in a single-player game at normal skill show no model.
void remove_left_out(const Level& level, LevelModels& models) {
    std::erase_if(models.models, [&](const LevelModel& model) { return is_left_out(level.entities[model.entity]); });
}

bool is_level_of(const LevelFiles& files, const std::string& level_file) {
    if (!files.game) return false;
    std::error_code ignored;
    return std::any_of(files.game->levels.begin(), files.game->levels.end(), [&](const std::string& level) {
        return fs::equivalent(level_file_of(*files.game, level), level_file, ignored);
    });
}

std::vector<std::string> sound_folders(const LevelFiles& files, const std::string& level_file) {
    std::vector<std::string> folders{fs::path(level_file).parent_path().string()};
    if (files.game && !files.game->folder.empty()) folders.insert(folders.begin(), files.game->folder);
    return folders;
}

std::string file_of_level(const LevelFiles& files) {
    if (!files.level.empty()) return files.level;
    if (files.game) return level_file_of(*files.game, files.game->levels.front());
    return (fs::path(files.assets) / kDemoLevelFile).string();
}

std::string file_of_palette(const LevelFiles& files, const std::string& level_file, const GameFiles& game) {
    if (!files.palette.empty()) return files.palette;
    if (files.game && !files.game->palette.empty() && is_level_of(files, level_file)) return files.game->palette;
    return find_palette(fs::path(level_file).parent_path(), game, files.assets);
}

}  // namespace

GameData load_game(const LevelFiles& files) {
    GameData data;
    data.level_file = file_of_level(files);
    const GameFiles game = game_files_of(data.level_file, files.game_folders);
    if (files.game) data.rules_hash = files.game->rules_hash;
    data.level = read_parsed_game_file(data.level_file, [&](std::span<const std::uint8_t> bytes) {
        data.level_hash = fnv1a_of(bytes) ^ data.rules_hash;
        return read_bsp(bytes);
    });
    print_warnings("oblong", data.level_file, read_lit_file_beside(data.level_file, data.level));
    if (files.game) apply_classes(*files.game, data.level.entities);
    print_warnings("oblong", data.level_file, texture_warnings(data.level));
    data.effects = read_level_effects(data.level);
    print_warnings("oblong", data.level_file, data.effects.warnings);
    print_warnings("oblong", data.level_file, read_things(data.level).warnings);
    data.palette = read_parsed_game_file(file_of_palette(files, data.level_file, game), read_palette);
    data.colormap = make_colormap(data.palette);
    data.models = read_level_models(
        data.level, data.palette,
        {data.level_file, files.models, files.assets, game.has_paks() ? &game : nullptr, files.game_folders});
    remove_left_out(data.level, data.models);
    print_warnings("oblong", data.level_file, data.models.warnings);
    data.sounds = read_level_sounds(data.level, sound_folders(files, data.level_file));
    print_warnings("oblong", data.level_file, data.sounds.warnings);
    return data;
}

}  // namespace oblong
