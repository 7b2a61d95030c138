#include <filesystem>

#include "game/options.h"
#include "game/run.h"

namespace {

// build/assets stands beside build/bin, wherever the build folder has been moved to.
std::string assets_folder(const char* called_as) {
    std::error_code error;
    std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error) program = std::filesystem::absolute(called_as);
    return (program.parent_path().parent_path() / "assets").string();
}

}  // namespace

int main(int argc, char** argv) {
    return oblong::run_with_options(
        argc, argv, [&](const oblong::Options& options) { oblong::run_game(options, assets_folder(argv[0])); });
}
