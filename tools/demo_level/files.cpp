#include "tools/demo_level/files.h"

#include <filesystem>
#include <sstream>

#include "engine/platform/files.h"
#include "tools/common/png.h"
#include "tools/demo_level/art/textures.h"
#include "tools/demo_level/map/museum.h"

namespace oblong {

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

void write_demo_textures(const std::string& folder) {
    make_folder(folder);
    const Palette palette = art::design_palette();
    for (const auto& [name, canvas] : art::paint_all_textures()) {
        const std::string path = (std::filesystem::path(folder) / (name + ".png")).string();
        write_file(path, encode_indexed_png(canvas.to_indices(), canvas.width(), canvas.height(), palette));
    }
}

}  // namespace oblong
