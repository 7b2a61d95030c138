#include "tools/common/obj_materials.h"

#include <algorithm>
#include <sstream>

#include "engine/platform/files.h"

namespace oblong {
namespace {

Skin skin_of_colour(const std::string& name, Rgb8 colour, const Palette& palette) {
    return {name, 1, 1, {nearest_colour(palette, colour, kOrdinaryColours)}};
}

Rgb8 diffuse_colour(const tinyobj::material_t& material) {
    const auto channel = [&](int i) {
        const double value = material.diffuse[i];
        return static_cast<std::uint8_t>(value > 0 ? std::min(value, 1.0) * 255 + 0.5 : 0);
    };
    return {channel(0), channel(1), channel(2)};
}

/// Paths in files of other systems have backslashes.
std::string with_slashes(std::string path) {
    std::replace(path.begin(), path.end(), '\\', '/');
    return path;
}

}  // namespace

bool ObjMaterialReader::operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                                   std::map<std::string, int>* numbers, std::string* warning, std::string* error) {
    try {
        std::istringstream text(read_text((folder_ / with_slashes(name)).string()));
        tinyobj::LoadMtl(numbers, materials, &text, warning, error);
        return true;
    } catch (const FileError& missing) {
        *warning += std::string(missing.what()) + "\n";
        return false;
    }
}

Skin make_skin(const tinyobj::material_t& material, const std::filesystem::path& folder, const Palette& palette,
               Dither dither, std::vector<std::string>& warnings) {
    if (material.diffuse_texname.empty()) return skin_of_colour(material.name, diffuse_colour(material), palette);
    try {
        const auto path = (folder / with_slashes(material.diffuse_texname)).string();
        const PngImage image = read_parsed(path, decode_png);
        return {material.name, image.width_px, image.height_px, indices_of(image, palette, kOrdinaryColours, dither)};
    } catch (const FileError& error) {
        warnings.push_back(std::string(error.what()) + ": the material's colour stands for it");
        return skin_of_colour(material.name, diffuse_colour(material), palette);
    }
}

Skin grey_skin(const Palette& palette) {
    return skin_of_colour("no material", {192, 192, 192}, palette);
}

}  // namespace oblong
