#include "game/program/program_files.h"

#include <filesystem>
#include <optional>
#include <utility>

#include "engine/files/files.h"
#include "game/level/level_search.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

// Checked before the game is played, not after it.
void check_writable(const std::string& file) {
    const fs::path folder = fs::path(file).parent_path();
    if (fs::is_directory(file)) throw FileError(file, "write", "is a folder, expected a file");
    if (!folder.empty() && !fs::is_directory(folder))
        throw FileError(file, "write", folder.string() + " is no folder, expected a folder for the file");
}

bool is_plain(char letter) {
    const bool is_letter = (letter | 32) >= 'a' && (letter | 32) <= 'z';
    return is_letter || (letter >= '0' && letter <= '9') || letter == '.' || letter == '-';
}

}  // namespace

std::string game_name(const std::string& folder) {
    if (folder.empty()) return kQuake;
    std::string name = fs::absolute(folder).lexically_normal().filename().string();
    if (name.empty()) name = fs::absolute(folder).lexically_normal().parent_path().filename().string();
    for (char& letter : name)
        if (!is_plain(letter)) letter = '_';
    return name == kMuseum || name.empty() ? "_" + name : name;
}

LevelFiles files_of_game(const LoadedLevel& first, const Options& options) {
    LevelFiles files = first.files;
    files.level.clear();
    files.palette = options.palette;
    if (!files.game) files.game = std::make_shared<const GameDefinition>();
    return files;
}

std::string saves_folder_of(const Options& options) {
    const std::string& data = options.folders.data;
    if (data.empty() || !is_game_folder(options.game)) return data;
    return (fs::path(data) / game_name(options.game)).string();
}

LevelFiles level_files_of(const Options& options, const std::string& assets_folder) {
    LevelFiles files{options.level, options.palette, assets_folder, options.models, game_folders_of(options.game)};
    const std::string& folder = is_game_folder(options.game) ? options.game : assets_folder;
    files.game = std::make_shared<const GameDefinition>(read_game_definition(folder));
    check_levels(*files.game);
    if (!options.map.empty()) files.level = find_named_level(options.map, {"", files.game_folders});
    return files;
}

ProgramFiles load_program_files(const Options& options, const std::string& assets_folder) {
    auto loaded = std::make_shared<const LoadedLevel>(level_files_of(options, assets_folder));
    std::optional<Demo> demo;
    if (!options.replay.empty()) demo = read_parsed(options.replay, decode_demo);
    if (!options.record.empty()) check_writable(options.record);
    const GameState start = start_of(loaded->level);
    return naming_file(options.replay, [&] {
        return ProgramFiles{assets_folder, loaded,
                            TickInputSource(start, std::move(demo), !options.record.empty(), loaded->data.rules_hash)};
    });
}

}  // namespace oblong
