#include <cstdlib>
#include <filesystem>

#include "game/options/options.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

// An absolute path from the environment, with `below` added; empty if there is none.
fs::path environment_folder(const char* variable, const char* below) {
    const char* const value = std::getenv(variable);
    if (value == nullptr || !fs::path(value).is_absolute()) return {};
    return fs::path(value) / below;
}

fs::path base_folder(const char* variable, const char* below_home) {
    const fs::path given = environment_folder(variable, "");
    return given.empty() ? environment_folder("HOME", below_home) : given;
}

}  // namespace

PlayerFolders desktop_folders() {
    const fs::path config = base_folder("XDG_CONFIG_HOME", ".config");
    const fs::path data = base_folder("XDG_DATA_HOME", ".local/share");
    PlayerFolders folders;
    if (!config.empty()) folders.config_file = (config / "oblong" / "oblong.cfg").string();
    if (!data.empty()) folders.data = (data / "oblong").string();
    return folders;
}

PlayerFolders portable_folders(const std::string& program_folder) {
    const fs::path folder = fs::path(program_folder) / "oblong-data";
    return {(folder / "oblong.cfg").string(), folder.string()};
}

}  // namespace oblong
