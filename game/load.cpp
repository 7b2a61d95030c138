#include "game/load.h"

#include <filesystem>

#include "engine/base/fnv.h"
#include "engine/effects/things.h"
#include "engine/level/bsp_read.h"
#include "engine/platform/files.h"
#include "tools/common/arguments.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

std::string find_palette(const fs::path& level_folder, const fs::path& assets) {
    for (const fs::path& file : {level_folder / "palette.lmp", level_folder / "gfx" / "palette.lmp"})
        if (fs::exists(file)) return file.string();
    return (assets / "palette.lmp").string();
}

}  // namespace

GameData load_game(const std::string& level_file, const std::string& palette_file, const std::string& assets_folder,
                   const std::string& models_folder) {
    GameData data;
    data.level_file = level_file.empty() ? (fs::path(assets_folder) / "demo.bsp").string() : level_file;
    data.level = read_parsed(data.level_file, [&](std::span<const std::uint8_t> bytes) {
        data.level_hash = fnv1a_of(bytes);
        return read_bsp(bytes);
    });
    data.effects = read_level_effects(data.level);
    print_warnings("oblong", data.level_file, data.effects.warnings);
    print_warnings("oblong", data.level_file, read_things(data.level).warnings);
    const std::string palette =
        palette_file.empty() ? find_palette(fs::path(data.level_file).parent_path(), assets_folder) : palette_file;
    data.palette = read_parsed(palette, read_palette);
    data.colormap = make_colormap(data.palette);
    data.models = read_level_models(data.level, data.palette, {data.level_file, models_folder, assets_folder});
    print_warnings("oblong", data.level_file, data.models.warnings);
    return data;
}

}  // namespace oblong
