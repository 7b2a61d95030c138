#include <CLI/CLI.hpp>

#include "tools/cli/program.h"
#include "tools/demo_level/files.h"

int main(int argc, char** argv) {
    CLI::App app{"Makes what the demo level is built from.", "oblong-demo-level"};
    app.set_version_flag("--version", OBLONG_VERSION);
    app.require_subcommand(1);
    std::string output;
    CLI::App& textures = *app.add_subcommand("textures", "the pictures on its walls, as indexed PNGs into a folder");
    CLI::App& map = *app.add_subcommand("map", "the level's source, for oblong-map");
    CLI::App& palette = *app.add_subcommand("palette", "its 256 colours, 768 bytes");
    for (CLI::App* command : {&textures, &palette, &map})
        command->add_option("-o", output, "what to write")->required();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return oblong::run_program("oblong-demo-level", [&] {
        if (textures.parsed()) oblong::write_demo_textures(output);
        if (map.parsed()) oblong::write_demo_map(output);
        if (palette.parsed()) oblong::write_demo_palette(output);
    });
}
