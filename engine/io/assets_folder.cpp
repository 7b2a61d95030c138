#include <filesystem>

#include "engine/io/files.h"
#include "engine/io/system.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

bool has_assets(const fs::path& folder) {
    std::error_code error;
    return fs::exists(folder / "palette.lmp", error);
}

}  // namespace

std::string program_folder(const char* called_as) {
    const fs::path program = program_file();
    return (program.empty() ? fs::absolute(called_as) : program).parent_path().string();
}

std::string assets_folder(const char* called_as) {
    const fs::path programs = program_folder(called_as);
    const fs::path built = programs.parent_path() / "assets";
    if (has_assets(built)) return built.string();
    const fs::path installed = (programs / OBLONG_ASSETS_FROM_PROGRAMS).lexically_normal();
    if (has_assets(installed)) return installed.string();
    throw FileError(installed.string(), "palette.lmp",
                    "not there, nor in " + built.string() + ", expected the program's own files in either");
}

}  // namespace oblong
