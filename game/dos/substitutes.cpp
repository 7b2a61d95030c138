// What the game asks of libraries that are not there under DOS.
#include <filesystem>
#include <string>

#include "engine/base/input_error.h"
#include "engine/files/command_line.h"
#include "engine/files/files.h"
#include "engine/files/game_definition.h"
#include "engine/files/level_models.h"
#include "engine/files/picture.h"
#include "game/dos/level_models_file.h"
#include "game/dos/museum.h"

namespace oblong {

/// There is no reader of JSON: what the museum's game.json says was written into museum.h by the build.
GameDefinition read_game_definition(const std::string& folder) {
    GameDefinition game;
    game.folder = folder;
    game.title = kMuseumTitle;
    game.levels = {kMuseumLevel};
    game.palette = (std::filesystem::path(folder) / kMuseumPalette).string();
    game.demo = (std::filesystem::path(folder) / kMuseumDemo).string();
    return game;
}

/// There is no reader of OBJ and PNG files: the build has read them.
LevelModels read_level_models(const Level&, const Palette&, const ModelFolders& folders) {
    const std::string file = std::filesystem::path(folders.level_file).replace_extension(".models").string();
    return read_parsed(file, decode_level_models);
}

/// Of PNG files and others: the museum has none but those of its models.
PngImage decode_picture(std::span<const std::uint8_t>) {
    throw InputError("image", "no pictures are read under DOS");
}

std::vector<std::uint8_t> encode_indexed_png(std::span<const std::uint8_t>, std::int32_t, std::int32_t,
                                             const Palette&) {
    throw InputError("image", "no pictures are written under DOS");
}

/// The options file is not kept.
std::optional<ConfigLine> parse_config_line(const std::string&) {
    return std::nullopt;
}

}  // namespace oblong
