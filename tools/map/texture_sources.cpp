#include "tools/map/texture_sources.h"

#include <algorithm>
#include <filesystem>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "engine/io/files.h"
#include "engine/programs/arguments.h"
#include "tools/texture/texture_files.h"

namespace oblong::map {
namespace {

namespace fs = std::filesystem;

std::string palette_of(const TextureSources& sources, const std::string& folder, const char* called_as) {
    const fs::path own = fs::path(folder) / "palette.lmp";
    return sources.palette.empty() && fs::exists(own) ? own.string() : palette_file(sources, called_as);
}

Wad read_source(const TextureSources& sources, const std::string& path, const char* called_as,
                std::vector<std::string>& files, TextureWarnings& warnings) {
    files.push_back(path);
    if (!fs::is_directory(path)) return naming_file(path, [&] { return Wad(read_text(path)); });
    const std::vector<std::string> pictures = pictures_in(path);
    files.insert(files.end(), pictures.begin(), pictures.end());
    const Palette palette = read_parsed(palette_of(sources, path, called_as), read_palette);
    const auto bytes = packed_textures(pictures, sources.glowing, palette, parse_dither(sources.dither), warnings);
    return Wad(std::string(bytes.begin(), bytes.end()));
}

// Empty, with a warning, if it is nowhere: who watches `files` sees it come.
std::string found_source(const std::string& name, int line, const fs::path& folder, const char* called_as,
                         std::vector<std::string>& files, Warnings& warnings) {
    const fs::path as_named = folder / name, last = fs::path(name).filename();  // an absolute name is unchanged
    for (const fs::path& path : {as_named, folder / last})
        if (fs::exists(path)) return path.string();
    const fs::path own = assets_folder(called_as) / last;
    if (fs::exists(own)) return own.string();
    files.push_back(as_named.string());
    warnings.add(line, "\"wad\" names '" + name + "', which is not at " + as_named.string() +
                           ", expected a WAD file or a folder of pictures there (or see --wad)");
    return "";
}

struct NamedSource {
    std::string path, name;
    int line = 0;  // 0: not from the map
};

std::vector<NamedSource> named_sources(const MapEntity& world, const std::string& map_path, const char* called_as,
                                       std::vector<std::string>& files, Warnings& warnings) {
    std::vector<NamedSource> sources;
    for (const MapPair& pair : world.pairs) {
        if (pair.key != "wad") continue;
        std::string names = pair.value;
        std::replace(names.begin(), names.end(), '\\', '/');
        for (const std::string& name : oblong::split(names, ";")) {
            if (name.empty()) continue;
            const std::string path =
                found_source(name, pair.line, fs::path(map_path).parent_path(), called_as, files, warnings);
            if (!path.empty()) sources.push_back({path, name, pair.line});
        }
    }
    return sources;
}

}  // namespace

std::string palette_file(const TextureSources& sources, const char* called_as) {
    if (!sources.palette.empty()) return sources.palette;
    if (!sources.game_palette.empty()) return sources.game_palette;
    return (fs::path(assets_folder(called_as)) / "palette.lmp").string();
}

std::vector<Wad> read_texture_sources(const TextureSources& sources, const MapEntity& world,
                                      const std::string& map_path, const char* called_as,
                                      std::vector<std::string>& files, Warnings& warnings) {
    std::vector<Wad> wads;
    std::vector<NamedSource> named;
    for (const std::string& path : sources.wads) named.push_back({path, path});
    if (named.empty()) named = named_sources(world, map_path, called_as, files, warnings);
    for (const NamedSource& each : named) {
        TextureWarnings odd;
        try {
            wads.push_back(read_source(sources, each.path, called_as, files, odd));
            wads.back().source = each.name;
            wads.back().line = each.line;
        } catch (const FileError& fault) {
            if (each.line == 0) throw;  // named on the command line
            odd.emplace_back(fault.what());
        }
        for (const std::string& what : odd) warnings.add(each.line > 0 ? each.line : world.line, what);
    }
    for (const std::string& name : sources.glowing)
        if (std::none_of(wads.begin(), wads.end(),
                         [&](const Wad& wad) { return wad.find(lower_case(name)) != nullptr; }))
            throw UsageError("--glow: '" + name + "', expected the name of one of the textures");
    return wads;
}

}  // namespace oblong::map
