#include "game/program/program_files.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/checksum.h"
#include "engine/base/input_error.h"
#include "engine/base/table.h"
#include "engine/io/files.h"
#include "engine/pictures/picture.h"
#include "engine/programs/arguments.h"
#include "game/level/level_search.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

constexpr std::int32_t kLargestIcon_px = 256;

// Otherwise the museum would be played in its place. With a level it may hold just what the level names.
void check_game_folder(const Options& options) {
    const fs::path folder = options.game;
    const bool has_game = is_game_folder(options.game) || fs::is_directory(folder / "maps") ||
                          GameFiles({options.game}).has_paks() || !options.level.empty();
    if (!fs::is_directory(folder) || !has_game)
        throw FileError(options.game, "--game",
                        "is no folder of a game, expected one with game.json, maps/ or pak0.pak");
}

bool is_plain(char letter) {
    const bool is_letter = (letter | 32) >= 'a' && (letter | 32) <= 'z';
    return is_letter || (letter >= '0' && letter <= '9') || letter == '.' || letter == '-' || letter == '_';
}

// A demo that is missing, or was recorded before the level's last change, is no error: it is recorded in the game.
void warn_of_demo(const GameDefinition& game, std::uint64_t start_hash) {
    const auto warn = [&](const std::string& what_is_wrong) {
        print_warnings("oblong", (fs::path(game.folder) / kGameFile).string(), {"/demo: " + what_is_wrong});
    };
    if (game.demo.empty()) return;
    if (!fs::exists(game.demo)) return warn("there is no file " + game.demo + ", expected one that --record wrote");
    if (read_parsed(game.demo, decode_demo).start_hash != start_hash)
        warn(game.demo + " is not shown: recorded on another level or by other rules, expected the first level's");
}

}  // namespace

// The museum has its saves beside the games' folders, with a file "lock".
std::string game_name(const std::string& folder) {
    if (folder.empty()) return kQuake;
    std::string name = fs::absolute(folder).lexically_normal().filename().string();
    if (name.empty()) name = fs::absolute(folder).lexically_normal().parent_path().filename().string();
    const std::uint64_t hash = fnv1a_of({reinterpret_cast<const std::uint8_t*>(name.data()), name.size()});
    const bool is_ascii = std::none_of(name.begin(), name.end(), [](char letter) { return (letter & 128) != 0; });
    for (char& letter : name)
        if (!is_plain(letter)) letter = '_';
    if (!is_ascii) name += "-" + std::to_string(hash);  // words of other alphabets have become alike
    return name == kMuseum || name == "lock" || name.empty() ? "_" + name : name;
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
    if (!options.game.empty()) check_game_folder(options);
    LevelFiles files{options.level, options.palette, assets_folder, options.models, game_folders_of(options.game)};
    const std::string& folder = is_game_folder(options.game) ? options.game : assets_folder;
    files.game = std::make_shared<const GameDefinition>(read_game_definition(folder));
    if (!options.map.empty()) files.level = find_named_level(options.map, {"", files.game_folders});
    return files;
}

ProgramFiles load_program_files(const Options& options, const LevelFiles& level) {
    auto loaded = std::make_shared<const LoadedLevel>(level);
    std::optional<Demo> demo;
    if (!options.replay.empty()) demo = read_parsed(options.replay, decode_demo);
    if (!options.record.empty()) check_writable(options.record);
    const GameState start = start_of(loaded->level);
    const bool shows_first_level = options.shows_title && options.level.empty() && options.map.empty();
    if (shows_first_level) warn_of_demo(*loaded->files.game, start_hash_of(start, loaded->data.rules_hash));
    return naming_file(options.replay, [&] {
        return ProgramFiles{loaded,
                            TickInputSource(start, std::move(demo), !options.record.empty(), loaded->data.rules_hash)};
    });
}

ProgramFiles load_program_files(const Options& options, const std::string& assets_folder) {
    return load_program_files(options, level_files_of(options, assets_folder));
}

OwnSounds own_sounds_of(const GameDefinition& game) {
    OwnSounds own{game.folder, {}, {}};
    for (const auto& [name, text] : game.captions) {
        if (is_replaceable(name)) continue;
        if (const std::optional<Sound> sound = find_sound(name))
            own.captions[*sound] = text;
        else if (!find_below({game.folder}, name).empty())
            own.level_captions[name] = text;
        else
            throw FileError((fs::path(game.folder) / kGameFile).string(), "/captions/" + printable(name),
                            "is no sound, expected the name of one in the museum's folder sounds, without number, or a "
                            "file below the folder; or words of the museum, as \"a lens\"");
    }
    return own;
}

void show_icon(const GameDefinition& game, Platform& platform) {
    if (game.icon.empty()) return;
    const PngImage icon = read_parsed(game.icon, decode_picture);
    if (icon.width_px > kLargestIcon_px || icon.height_px > kLargestIcon_px)
        throw FileError(game.icon, "size",
                        std::to_string(icon.width_px) + "x" + std::to_string(icon.height_px) +
                            " pixels, expected up to 256x256 of an icon");
    std::vector<std::uint8_t> rgba;
    for (std::size_t at = 0; at < as_size(icon.width_px) * as_size(icon.height_px); ++at) {
        const Rgba8 pixel = icon.pixel(at);
        rgba.insert(rgba.end(), {pixel.colour.red, pixel.colour.green, pixel.colour.blue, pixel.alpha});
    }
    platform.set_icon(rgba, {icon.width_px, icon.height_px});
}

}  // namespace oblong
