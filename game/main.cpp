#include <exception>
#include <filesystem>
#include <iostream>

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

int main(int argument_count, char** arguments) {
    const oblong::ParsedOptions parsed = oblong::parse_options(argument_count, arguments);
    if (parsed.ends) return parsed.exit_code;
    try {
        oblong::run_game(parsed.options, assets_folder(arguments[0]));
    } catch (const std::exception& error) {
        std::cerr << "oblong: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
