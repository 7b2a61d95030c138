#include <filesystem>
#include <sstream>

#include "engine/files/command_line.h"
#include "engine/files/files.h"
#include "engine/files/png.h"
#include "tools/demo_level/art/textures.h"
#include "tools/demo_level/map/museum.h"
#include "tools/demo_level/models/models.h"
#include "tools/demo_level/sounds/sounds.h"

namespace oblong {
namespace {

void write_demo_palette(const std::string& path) {
    std::vector<std::uint8_t> bytes;
    for (const Rgb8& colour : art::design_palette().colours) {
        bytes.insert(bytes.end(), {colour.red, colour.green, colour.blue});
    }
    write_file(path, bytes);
}

void write_demo_map(const std::string& path) {
    std::ostringstream text;
    map_source::write_map(map_source::make_museum(), text);
    write_file(path, text.str());
}

void write_pictures(const std::vector<art::NamedCanvas>& pictures, const std::string& folder) {
    make_folder(folder);
    const Palette palette = art::design_palette();
    for (const auto& [name, canvas] : pictures) {
        const std::string path = (std::filesystem::path(folder) / (name + ".png")).string();
        write_file(path, encode_indexed_png(canvas.to_indices(), canvas.width(), canvas.height(), palette));
    }
}

void write_demo_models(const std::string& folder) {
    write_pictures(model_source::paint_all_skins(), folder);
    for (const auto& [name, text] : model_source::all_model_files())
        write_file((std::filesystem::path(folder) / name).string(), text);
}

void write_sounds(const std::string& folder) {
    make_folder(folder);
    for (const auto& [name, samples] : sound_source::make_all_sounds())
        write_file((std::filesystem::path(folder) / (name + ".wav")).string(), sound_source::encode_wave(samples));
}

}  // namespace
}  // namespace oblong

int main(int argc, char** argv) {
    using namespace oblong;
    std::string output;
    CommandLine line("oblong-demo-level", "Makes what the demo level is built from.");
    CommandArguments textures =
        line.add_command("textures", "the pictures on its walls, as indexed PNGs into a folder");
    CommandArguments models =
        line.add_command("models", "what stands in it: OBJ files with their skins, into a folder");
    CommandArguments sounds = line.add_command("sounds", "what is heard in the game, as WAV files into a folder");
    CommandArguments music = line.add_command("music", "the title's music, a tracker module");
    CommandArguments map = line.add_command("map", "the level's source, for oblong-map");
    CommandArguments palette = line.add_command("palette", "its 256 colours, 768 bytes");
    for (CommandArguments* command : {&textures, &models, &sounds, &music, &map, &palette})
        command->add("-o", output, "what to write").require();
    return line.run(argc, argv, [&] {
        if (textures.is_given()) write_pictures(art::paint_all_textures(), output);
        if (models.is_given()) write_demo_models(output);
        if (sounds.is_given()) write_sounds(output);
        if (music.is_given()) write_file(output, sound_source::make_title_music());
        if (map.is_given()) write_demo_map(output);
        if (palette.is_given()) write_demo_palette(output);
    });
}
