#include "tools/common/command_line.h"
#include "tools/demo_level/files.h"

int main(int argc, char** argv) {
    using namespace oblong;
    std::string output;
    CommandLine line("oblong-demo-level", "Makes what the demo level is built from.");
    Command textures = line.add_command("textures", "the pictures on its walls, as indexed PNGs into a folder");
    Command map = line.add_command("map", "the level's source, for oblong-map");
    Command palette = line.add_command("palette", "its 256 colours, 768 bytes");
    for (Command* command : {&textures, &map, &palette}) command->add("-o", output, "what to write").require();
    return line.run(argc, argv, [&] {
        if (textures.is_given()) write_demo_textures(output);
        if (map.is_given()) write_demo_map(output);
        if (palette.is_given()) write_demo_palette(output);
    });
}
