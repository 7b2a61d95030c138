#include <CLI/CLI.hpp>

#include "engine/platform/files.h"
#include "tools/cli/program.h"
#include "tools/texture/texture_files.h"

namespace {

struct Request {
    std::vector<std::string> inputs;
    std::string output, palette;
};

void add_options(CLI::App& command, Request& request, const std::string& input_help, const std::string& output_help) {
    command.add_option("input", request.inputs, input_help)->required();
    command.add_option("-o", request.output, output_help)->required();
    command.add_option("--palette", request.palette, "768 bytes: red, green, blue of 256 colours")->required();
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Textures in and out of Quake's files.", "oblong-texture"};
    app.set_version_flag("--version", OBLONG_VERSION);
    app.require_subcommand(1);
    Request request;
    CLI::App& pack = *app.add_subcommand(
        "pack", "PNGs into a WAD2. A texture is named after its file; a leading '#' becomes '*' (liquids).");
    CLI::App& unpack = *app.add_subcommand("unpack", "The textures of a WAD2 or a BSP as indexed PNGs.");
    add_options(pack, request, "PNG files, sizes multiples of 16", "the WAD to write");
    add_options(unpack, request, "a WAD2 or BSP file", "the folder to write to");
    unpack.get_option("input")->expected(1);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return oblong::run_program("oblong-texture", [&] {
        const oblong::Palette palette = oblong::read_parsed(request.palette, oblong::read_palette);
        if (pack.parsed()) oblong::pack_textures(request.inputs, request.output, palette);
        if (unpack.parsed()) oblong::unpack_textures(request.inputs.front(), request.output, palette);
    });
}
