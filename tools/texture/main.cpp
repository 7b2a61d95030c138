#include <iostream>

#include "engine/base/input_error.h"
#include "engine/io/files.h"
#include "engine/programs/command_line.h"
#include "tools/texture/texture_files.h"

namespace {

void print_warnings(const std::string& file, const oblong::TextureWarnings& warnings) {
    for (const std::string& warning : warnings)
        std::cerr << oblong::printable("oblong-texture: " + file + ": warning: " + warning) << '\n';
}

}  // namespace

int main(int argc, char** argv) {
    using namespace oblong;
    std::vector<std::string> pictures, glowing;
    std::string archive, output, palette_file, dither = "none";
    CommandLine line("oblong-texture", "Textures in and out of Quake's files, and how light changes their colours.");
    CommandArguments pack = line.add_command(
        "pack", "Pictures into a WAD2. A texture is named after its file; a leading '#' becomes '*' (liquids).");
    CommandArguments unpack = line.add_command("unpack", "The textures of a WAD2 or a BSP as indexed PNGs.");
    CommandArguments ramps = line.add_command(
        "ramps", "The colormap of a palette as a PNG: a row for each colour, brightest shade to darkest.");
    pack.add("input", pictures, "PNG, TGA, JPEG or BMP files, or folders of them, sizes multiples of 16").require();
    pack.add("-o", output, "the WAD to write").require();
    pack.add("--glow", glowing,
             "texture NAME whose colours may glow (palette indices 224 to 255); may be given more than once");
    pack.add("--dither", dither,
             "none: each pixel the nearest colour; floyd-steinberg: its error goes to its neighbours");
    unpack.add("input", archive, "a WAD2 or BSP file").require();
    unpack.add("-o", output, "the folder to write to").require();
    ramps.add("-o", output, "the PNG to write").require();
    for (CommandArguments* command : {&pack, &unpack, &ramps})
        command->add("--palette", palette_file, "768 bytes: red, green, blue of 256 colours").require();
    return line.run(argc, argv, [&] {
        check_replaces_none("-o", output, {palette_file});
        const Palette palette = read_parsed(palette_file, read_palette);
        if (pack.is_given())
            print_warnings(output, pack_textures(pictures, glowing, output, palette, parse_dither(dither)));
        if (unpack.is_given()) print_warnings(archive, unpack_textures(archive, output, palette));
        if (ramps.is_given()) write_file(output, make_ramp_sheet(palette));
    });
}
