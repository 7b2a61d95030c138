#include "tools/demo_level/files.h"

#include <filesystem>
#include <sstream>

#include "tools/demo_level/art/catalogue.h"
#include "tools/demo_level/map/museum.h"
#include "tools/png/indexed_png.h"
#include "tools/texture/texture_files.h"

namespace oblong {

void write_demo_palette(const std::string& path) {
    std::vector<std::uint8_t> bytes;
    for (const Rgb8& colour : art::design_palette().colours) {
        bytes.insert(bytes.end(), {colour.red, colour.green, colour.blue});
    }
    write_whole_file(path, bytes);
}

void write_demo_map(const std::string& path) {
    std::ostringstream text;
    map_source::write_map(map_source::make_museum(), text);
    const std::string characters = text.str();
    write_whole_file(path, {characters.begin(), characters.end()});
}

void write_demo_textures(const std::string& folder) {
    std::filesystem::create_directories(folder);
    const Palette palette = art::design_palette();
    for (const auto& [name, canvas] : art::paint_all_textures()) {
        const std::string path = (std::filesystem::path(folder) / (name + ".png")).string();
        write_indexed_png(path, canvas.to_indices(), canvas.width(), canvas.height(), palette);
    }
}

}  // namespace oblong
