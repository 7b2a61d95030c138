#include <filesystem>
#include <optional>
#include <vector>

#include "engine/base/table.h"
#include "engine/files/files.h"
#include "engine/files/picture.h"
#include "game/program/program_files.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

constexpr std::int32_t kLargestIcon_px = 256;

}  // namespace

OwnSounds own_sounds_of(const GameDefinition& game) {
    OwnSounds own{game.folder, {}, {}};
    for (const auto& [name, text] : game.captions) {
        if (name == kOneLens || name == kLenses) continue;
        if (const std::optional<Sound> sound = find_sound(name))
            own.captions[*sound] = text;
        else if (stays_below(name) && fs::is_regular_file(fs::path(game.folder) / name))
            own.level_captions[name] = text;
        else
            throw FileError((fs::path(game.folder) / kGameFile).string(), "/captions/" + name,
                            "is no sound, expected the name of one in the museum's folder sounds, without number, or a "
                            "file below the folder; or \"a lens\" or \"lenses\"");
    }
    return own;
}

void show_icon(const GameDefinition& game, Platform& platform) {
    if (game.icon.empty() || !platform.shows_icon()) return;
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
