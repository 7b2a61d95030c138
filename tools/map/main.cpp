#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "tools/map/compile.h"
#include "tools/map/files.h"

namespace {

using namespace oblong;

struct Arguments {
    std::string input, output;
    std::vector<std::string> wads;
    bool is_fast = false;
};

void declare(CLI::App& app, Arguments& arguments) {
    app.set_version_flag("--version", "oblong-map " OBLONG_VERSION);
    app.add_option("IN.map", arguments.input, "the level's source: Quake .map, Standard or Valve 220")->required();
    app.add_option("-o,--out", arguments.output, "the level to write: OUT.bsp, version 29")->required();
    app.add_option("--wad", arguments.wads, "a WAD2 file of textures; may be given more than once");
    app.add_flag("--fast", arguments.is_fast, "rougher visibility and light");
}

// Runs a step that works on one file, and adds the file's name to what may go wrong.
template <class Step>
auto on_file(const std::string& path, Step step) {
    try {
        return step();
    } catch (const InputError& error) {
        throw InputError(path + ": " + error.where, error.what());
    }
}

void compile_to_file(const Arguments& arguments) {
    const std::string text = on_file(arguments.input, [&] { return map::read_file(arguments.input); });
    std::vector<map::Wad> wads;
    for (const std::string& path : arguments.wads)
        wads.push_back(on_file(path, [&] { return map::Wad(map::read_file(path)); }));
    const std::string points_path = std::filesystem::path(arguments.output).replace_extension(".pts").string();
    const std::string bytes = on_file(arguments.input, [&] {
        try {
            return map::to_bytes(map::compile_map(text, wads, {arguments.is_fast}));
        } catch (const map::LeakError& leak) {
            on_file(points_path, [&] { map::write_file(points_path, map::points_text(leak.path) + "\n"); });
            throw;
        }
    });
    on_file(arguments.output, [&] { map::write_file(arguments.output, bytes); });
}

}  // namespace

int main(int argument_count, char** arguments_given) {
    CLI::App app{"Compiles the source of a level to a Quake BSP file (version 29)", "oblong-map"};
    Arguments arguments;
    declare(app, arguments);
    try {
        app.parse(argument_count, arguments_given);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        compile_to_file(arguments);
    } catch (const InputError& error) {
        std::cerr << "oblong-map: " << error.where << ": " << error.what() << '\n';
        return 1;
    }
    return 0;
}
