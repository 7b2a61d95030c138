#include <filesystem>
#include <iostream>

#include "engine/files/arguments.h"
#include "engine/files/command_line.h"
#include "engine/files/files.h"
#include "tools/map/compile.h"
#include "tools/map/source/checks.h"
#include "tools/map/source/fgd.h"

namespace {

using namespace oblong;

struct Arguments {
    std::string input, output, fgd;
    std::vector<std::string> wads;
    bool is_fast = false;
};

void declare(CommandArguments& line, Arguments& arguments) {
    line.add("IN.map", arguments.input, "the level's source: Quake .map, Standard or Valve 220");
    line.add("-o,--out", arguments.output, "the level to write: OUT.bsp, version 29");
    line.add("--wad", arguments.wads, "a WAD2 file of textures; may be given more than once");
    line.add("--fgd", arguments.fgd, "writes the classes and keys that editors show, and compiles nothing");
    line.add_flag("--fast", arguments.is_fast, "rougher visibility and light");
}

std::string points_path(const Arguments& arguments) {
    return std::filesystem::path(arguments.output).replace_extension(".pts").string();
}

void print(map::Warnings& warnings, const Arguments& arguments) {
    for (const map::Warning& warning : warnings.take())
        std::cerr << "oblong-map: " << arguments.input << ": line " << warning.line << ": warning: " << warning.what
                  << '\n';
}

std::string compile(const Arguments& arguments, const std::string& text, const std::vector<map::Wad>& wads) {
    std::vector<map::MapEntity> entities = map::parse_map(text);
    map::Warnings warnings;
    map::find_warnings(entities, warnings);
    print(warnings, arguments);
    try {
        std::string level = map::to_bytes(map::compile_map(std::move(entities), wads, {arguments.is_fast, &warnings}));
        print(warnings, arguments);
        return level;
    } catch (const map::LeakError& leak) {
        write_file(points_path(arguments), map::points_text(leak.path) + "\n");
        throw InputError(leak.where, std::string(leak.what()) + "; the way out is in " + points_path(arguments));
    }
}

void compile_to_file(const Arguments& arguments) {
    if (arguments.input.empty()) throw UsageError("IN.map is required");
    if (arguments.output.empty()) throw UsageError("--out is required");
    const std::string text = read_text(arguments.input);
    std::vector<map::Wad> wads;
    for (const std::string& path : arguments.wads)
        wads.push_back(naming_file(path, [&] { return map::Wad(read_text(path)); }));
    write_file(arguments.output, naming_file(arguments.input, [&] { return compile(arguments, text, wads); }));
    const std::string points = points_path(arguments);  // the way out of a leak that is closed now
    if (points != arguments.output && std::filesystem::is_regular_file(points)) std::filesystem::remove(points);
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CommandLine line("oblong-map", "Compiles the source of a level to a Quake BSP file (version 29).");
    declare(line, arguments);
    return line.run(argc, argv, [&] {
        if (arguments.fgd.empty()) return compile_to_file(arguments);
        write_file(arguments.fgd, map::fgd_text());
    });
}
