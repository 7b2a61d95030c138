#include "game/level/level_search.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/base/text.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLevelExtension = ".bsp";
constexpr const char* kPakPrefix = "maps/";
constexpr const char* kItemPrefix = "b_";  // Quake's ammunition boxes are .bsp files, too
constexpr const char* kDemoLevel = "demo";

// True for a file name without a folder: levels name other levels.
bool is_level_name(const std::string& name) {
    return !name.empty() && name.front() != '.' && name.find_first_of("/\\") == std::string::npos;
}

// That name, there or not, and those in `folder` that differ in capitals alone, as on DOS's disks.
std::vector<std::string> in_any_case(const fs::path& folder, const std::string& wanted) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name != wanted && lower_case(name) == lower_case(wanted)) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    names.insert(names.begin(), wanted);
    return names;
}

// Without repetitions.
std::vector<fs::path> folders_of(const LevelPlaces& places) {
    std::vector<fs::path> folders;
    const auto add = [&](const fs::path& folder) {
        const fs::path normal = folder.lexically_normal();
        if (std::find(folders.begin(), folders.end(), normal) == folders.end()) folders.push_back(normal);
    };
    if (!places.beside.empty() && !path_in_pak(places.beside)) add(fs::path(places.beside).parent_path() / ".");
    add(".");
    add("maps");
    for (const std::string& folder : places.game_folders)
        for (const std::string& maps : in_any_case(folder, "maps")) add(fs::path(folder) / maps);
    return folders;
}

std::vector<fs::path> levels_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code ignored;
        if (lower_case(entry->path().extension().string()) == kLevelExtension && entry->is_regular_file(ignored))
            files.push_back(entry->path().lexically_normal());
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

std::vector<std::string> game_folders_of(const std::string& named) {
    if (!named.empty()) return {named};
    std::vector<std::string> folders = in_any_case(".", "id1");
    folders.insert(folders.begin(), ".");
    return folders;
}

std::optional<std::string> find_level(const std::string& name, const LevelPlaces& places) {
    if (!is_level_name(name)) return {};
    std::error_code ignored;
    for (const fs::path& folder : folders_of(places))
        for (const std::string& file : in_any_case(folder, name + kLevelExtension))
            if (fs::is_regular_file(folder / file, ignored)) return (folder / file).lexically_normal().string();
    return GameFiles(places.game_folders).find(kPakPrefix + name + kLevelExtension);
}

std::string find_named_level(const std::string& name, const LevelPlaces& places) {
    if (auto file = find_level(name, places)) return *file;
    std::string looked, paks;
    for (const fs::path& folder : folders_of(places)) looked += folder.string() + ", ";
    for (const std::string& folder : places.game_folders) paks += (paks.empty() ? "" : ", ") + folder;
    throw FileError(name + kLevelExtension, "open",
                    "no such level in " + looked + "or pak files in " + paks + ", expected one");
}

LevelList list_levels(const LevelPlaces& places) {
    LevelList list{{{kDemoLevel, ""}}, {}};
    std::set<std::string> names;
    const auto add = [&](const std::string& file) {
        std::string name = fs::path(file).stem().string();
        const bool is_listed = is_level_name(name) && !name.starts_with(kItemPrefix) && !name.ends_with(kDraftEnding);
        if (is_listed && names.insert(name).second) list.levels.push_back({std::move(name), file});
    };
    for (const fs::path& folder : folders_of(places))
        for (const fs::path& file : levels_in(folder)) add(file.string());
    std::vector<std::string> in_paks =
        GameFiles(places.game_folders).list_in_paks(kPakPrefix, kLevelExtension, list.problems);
    std::stable_sort(in_paks.begin(), in_paks.end(), [](const std::string& a, const std::string& b) {
        return fs::path(a).stem() < fs::path(b).stem();
    });
    for (const std::string& file : in_paks) add(file);
    return list;
}

}  // namespace oblong
