// Substitutes for functions whose libraries are missing under DOS.
#include <cstdlib>
#include <filesystem>
#include <string>

#include "engine/base/input_error.h"
#include "engine/io/files.h"
#include "engine/level/t_junctions.h"
#include "engine/pictures/picture.h"
#include "engine/programs/command_line.h"
#include "engine/programs/game_definition.h"
#include "engine/sound/small_mixer.h"
#include "engine/sound/sound_file.h"
#include "game/dos/museum.h"
#include "game/dos/prepared_game.h"
#include "game/program/map_watch.h"

namespace oblong {

/// There is no JSON reader: the build has written the museum's game.json into museum.h.
GameDefinition read_game_definition(const std::string& folder) {
    GameDefinition game;
    game.folder = folder;
    game.title = kMuseumTitle;
    game.levels = {kMuseumLevel};
    game.palette = (std::filesystem::path(folder) / kMuseumPalette).string();
    game.demo = (std::filesystem::path(folder) / kMuseumDemo).string();
    return game;
}

/// The museum, prepared by the build: there is no reader of OBJ and PNG files, no music, and the rest takes seconds on
/// a 486.
GameData load_game(const LevelFiles& files) {
    const auto file = [&](const char* name) { return (std::filesystem::path(files.assets) / name).string(); };
    GameData data;
    data.level_file = file(kDemoLevelFile);
    data.palette = read_parsed(files.game->palette, read_palette);
    read_parsed(data.level_file,
                [&](std::span<const std::uint8_t> bytes) { return decode_prepared_game(bytes, data); });
    std::erase_if(data.level.entities.front().pairs, [](const auto& pair) { return pair.first == "music"; });
    data.sounds = read_level_sounds(data.level, {files.assets});
    data.effects = read_level_effects(data.level);
    return data;
}

/// Found by the build in the museum, the only level.
TJunctions::TJunctions(const Level& level) : found_(level.edges.size()) {
    read_parsed("/assets/demo.edges", [&](std::span<const std::uint8_t> bytes) {
        Reader reader(bytes);
        for (Found& found : found_) {
            std::uint16_t count = 0;
            reader.number(count);
            found = {vertices_.size(), count};
            for (std::size_t i = 0; i < count; ++i) {
                std::int32_t vertex = 0;
                reader.number(vertex);
                vertices_.emplace_back(vertex);
            }
        }
    });
}

/// The build has converted them to the mixer's format.
SoundSamples decode_flac(std::span<const std::uint8_t> file) {
    SoundSamples sound{SmallMixer::kRate_hz, {}};
    sound.samples.reserve(file.size());
    for (const std::uint8_t byte : file)
        sound.samples.push_back(static_cast<std::int16_t>(static_cast<std::int8_t>(byte) * 256));
    return sound;
}

/// No picture files: the museum has only those of its models, which are prepared.
PngImage decode_picture(std::span<const std::uint8_t>) {
    throw InputError("image", "no pictures are read under DOS");
}

std::vector<std::uint8_t> encode_indexed_png(std::span<const std::uint8_t>, std::int32_t, std::int32_t,
                                             const Palette&) {
    throw InputError("image", "no pictures are written under DOS");
}

/// No maps are watched.
std::optional<MapWatch::Result> MapWatch::poll(std::uint64_t) {
    return std::nullopt;
}
std::string MapWatch::due_reminder(std::uint64_t) {
    return {};
}
void MapWatch::remind_of(std::string) {}

/// There is no options file.
std::optional<ConfigLine> parse_config_line(const std::string&) {
    return std::nullopt;
}

}  // namespace oblong

// Replaces the library's own, which would add a demangler.
void __gnu_cxx::__verbose_terminate_handler() {
    std::abort();
}
