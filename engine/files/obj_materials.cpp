#include <algorithm>
#include <cmath>
#include <sstream>

#include "engine/base/table.h"
#include "engine/files/doubles.h"
#include "engine/files/files.h"
#include "engine/files/obj_parts.h"
#include "engine/files/picture.h"

namespace oblong {
namespace {

constexpr std::int32_t kLargestSkinSide = 4096;
constexpr double kRounding = 1.0 / 1024;  ///< of coordinates in files, repetitions

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

/// The number of repetitions of a skin along a side of `size` texels, from the whole number below `least`.
std::int32_t repetitions(double least, double greatest, std::int32_t size, bool& is_cut) {
    const double wanted = std::max(std::ceil(greatest - kRounding) - std::floor(least + kRounding), 1.0);
    const std::int32_t most = std::max(kLargestSkinSide / size, 1);
    is_cut |= wanted > most;
    return static_cast<std::int32_t>(std::min<double>(wanted, most));
}

std::int32_t whole_repetitions(double least) {
    return static_cast<std::int32_t>(std::floor(least + kRounding));
}

Skin repeated(const Skin& skin, std::int32_t across, std::int32_t down) {
    Skin larger{skin.name, skin.width * across, skin.height * down, {}};
    for (std::int32_t y = 0; y < larger.height; ++y)
        for (std::int32_t x = 0; x < larger.width; ++x)
            larger.texels.push_back(item(skin.texels, y % skin.height * skin.width + x % skin.width));
    return larger;
}

}  // namespace

void PlaceRange::include(const SkinPlace& place) {
    least = {std::min(least.u, place.u), std::min(least.v, place.v)};
    greatest = {std::max(greatest.u, place.u), std::max(greatest.v, place.v)};
}

MeshTexel SkinScale::texel_at(const SkinPlace& place) const {
    return {fixed_of<Texel>((place.u - first_u) * width), fixed_of<Texel>((place.v - first_v) * height)};
}

SkinScale repeat_skin(Skin& skin, const PlaceRange& range, std::vector<std::string>& warnings) {
    if (range.least.u > range.greatest.u) return {};
    const SkinScale scale{whole_repetitions(range.least.u), whole_repetitions(range.least.v),
                          static_cast<double>(skin.width), static_cast<double>(skin.height)};
    bool is_cut = false;
    const std::int32_t across = repetitions(range.least.u, range.greatest.u, skin.width, is_cut),
                       down = repetitions(range.least.v, range.greatest.v, skin.height, is_cut);
    if (across > 1 || down > 1) skin = repeated(skin, across, down);
    if (is_cut)
        warnings.push_back("material '" + skin.name + "' is repeated over more than " +
                           std::to_string(kLargestSkinSide) + " texels: beyond, its border is shown");
    return scale;
}

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
        const PngImage image = read_parsed(path, decode_picture);
        return {material.name, image.width_px, image.height_px, indices_of(image, palette, kOrdinaryColours, dither)};
    } catch (const FileError& error) {
        warnings.push_back(std::string(error.what()) + ": the material's colour stands for it");
        return skin_of_colour(material.name, diffuse_colour(material), palette);
    }
}

Skin resized(const Skin& skin, const Skin& other) {
    if (skin.width == other.width && skin.height == other.height) return skin;
    Skin result{skin.name, other.width, other.height, {}};
    for (std::int32_t y = 0; y < result.height; ++y)
        for (std::int32_t x = 0; x < result.width; ++x)
            result.texels.push_back(
                item(skin.texels, y * skin.height / result.height * skin.width + x * skin.width / result.width));
    return result;
}

Skin grey_skin(const Palette& palette) {
    return skin_of_colour("no material", {192, 192, 192}, palette);
}

}  // namespace oblong
