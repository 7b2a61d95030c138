#include <filesystem>

#include "engine/base/checksum.h"
#include "engine/files/game_files.h"
#include "game/saves/saved_game.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

std::string absolute(const std::string& path) {
    std::error_code ignored;
    return path.empty() ? "" : fs::absolute(path, ignored).lexically_normal().string();
}

bool is_at_hand(const std::string& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) || path_in_pak(path);
}

std::uint64_t hash_of_colours(const Palette& palette) {
    Fnv1a hash;
    for (const Rgb8 colour : palette.colours)
        for (const std::uint8_t byte : {colour.red, colour.green, colour.blue}) hash.add(byte);
    return hash.value();
}

bool is_demo_level(const std::string& name, const std::string& assets) {
    std::error_code ignored;
    if (fs::path(name).filename() != kDemoLevelFile) return false;
    return !fs::exists(name, ignored) || fs::equivalent(name, fs::path(assets) / kDemoLevelFile, ignored);
}

}  // namespace

SavedLevel saved_level_of(const LoadedLevel& loaded) {
    const GameData& data = loaded.data;
    SavedLevel saved;
    saved.name = is_at_hand(data.level_file) ? absolute(data.level_file) : data.level_file;
    saved.palette = absolute(loaded.files.palette);
    saved.models = absolute(loaded.files.models);
    if (!loaded.files.level.empty())  // the demo level belongs to no game
        for (const std::string& folder : loaded.files.game_folders) saved.game_folders.push_back(absolute(folder));
    saved.file_hash = data.level_hash;
    saved.start_hash = hash_of(start_of(loaded.level));
    saved.palette_hash = hash_of_colours(data.palette);
    saved.model_count = static_cast<std::uint32_t>(data.models.models.size());
    return saved;
}

LevelFiles files_of(const SavedLevel& saved, const LevelFiles& own) {
    LevelFiles files = own;
    if (!is_demo_level(saved.name, own.assets)) {
        files.level = saved.name;
        files.game_folders = saved.game_folders;
    }
    if (saved.palette.empty() || is_at_hand(saved.palette)) files.palette = saved.palette;
    if (saved.models.empty() || is_at_hand(saved.models)) files.models = saved.models;
    return files;
}

std::string what_is_gone(const SavedLevel& saved, const SavedLevel& loaded) {
    std::string text;
    if (loaded.palette_hash != saved.palette_hash)
        text += "Its colours differ from those when it was saved: " +
                (saved.palette.empty() ? "the palette of its game" : saved.palette) + " is gone or another file.\n";
    if (loaded.model_count < saved.model_count)
        text += "It is shown without " + std::to_string(saved.model_count - loaded.model_count) + " of the " +
                std::to_string(saved.model_count) + " models that it had when it was saved: " +
                (saved.models.empty() ? "the files of its game" : saved.models) + " are gone.\n";
    return text;
}

}  // namespace oblong
