#include "tools/texture/texture_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "engine/base/input_error.h"
#include "engine/base/little_endian.h"
#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/effects/sky.h"
#include "engine/io/files.h"
#include "engine/io/wad.h"
#include "engine/level/bsp_file.h"
#include "engine/level/bsp_read.h"
#include "engine/pictures/picture.h"
#include "engine/programs/arguments.h"
#include "engine/programs/command_line.h"
#include "engine/scene/texture_animation.h"
#include "engine/surface/colormap.h"
#include "engine/surface/palette.h"
#include "engine/view/screen.h"

namespace oblong {

namespace {

constexpr std::int32_t kRampCellWidth_px = 8, kRampCellHeight_px = 4;

/// "any/folder/#water.png" -> "*water": the file's name without folder and ending, a leading '#' stands for the '*' of
/// liquids, which is unsafe in file names.
std::string texture_name_of_file(const std::string& path) {
    std::string name = std::filesystem::path(path).stem().string();
    if (name.starts_with('#')) name[0] = '*';
    return name;
}

void check_texture_name(const std::string& name) {
    constexpr std::size_t kLongestName = 15;
    if (name.empty() || name.size() > kLongestName)
        throw InputError("name", "'" + name + "' has " + std::to_string(name.size()) +
                                     " characters, expected 1 to 15 of a texture's name");
}

std::vector<std::uint8_t> texels_of(const PngImage& image, const std::string& name, const Palette& palette,
                                    PngColours colours) {
    const ColourRange range{0, !colours.may_glow ? kFirstFullbright : has_holes(name) ? kHole : 256};
    std::vector<std::uint8_t> texels = indices_of(image, palette, range, colours.dither);
    for (std::size_t at = 0; at < texels.size(); ++at) {
        if (image.pixel(at).alpha >= 128) continue;
        if (!has_holes(name))
            throw InputError("image",
                             "has transparent pixels, expected none: only a texture whose name begins with "
                             "'{' has holes");
        texels[at] = kHole;
    }
    return texels;
}

/// The file of each texture, by the name that levels look for.
std::map<std::string, std::string> files_by_name(const std::vector<std::string>& picture_paths) {
    std::map<std::string, std::string> files;
    for (const std::string& path : picture_paths) {
        const std::string name = texture_name_of_file(path);
        const auto [other, is_new] = files.emplace(lower_case(name), path);
        if (!is_new)
            throw FileError(
                path, "name",
                "is also the texture name of " + other->second + ": '" + name + "', expected one file per name");
    }
    return files;
}

/// A folder stands for the pictures in it.
std::vector<std::string> files_of_paths(const std::vector<std::string>& paths) {
    std::vector<std::string> files;
    for (const std::string& path : paths) {
        const bool is_folder = std::filesystem::is_directory(path);
        for (std::string& file : is_folder ? pictures_in(path) : std::vector{path}) files.push_back(std::move(file));
    }
    return files;
}

/// Warns of pictures that are no textures; throws if none is one.
std::vector<MipTexture> read_pictures(const std::vector<std::string>& files, const std::vector<std::string>& glowing,
                                      const Palette& palette, Dither dither, TextureWarnings& warnings) {
    const std::map<std::string, std::string> by_name = files_by_name(files);
    std::set<std::string> glowing_files;
    for (const std::string& name : glowing)
        if (const auto file = by_name.find(lower_case(name)); file != by_name.end()) glowing_files.insert(file->second);
    std::vector<MipTexture> textures;
    for (const std::string& path : files) {
        const std::vector<std::uint8_t> bytes = read_file(path);
        try {
            textures.push_back(picture_texture(path, bytes, palette, {glowing_files.contains(path), dither}));
        } catch (const FileError& fault) {
            if (path == files.back() && textures.empty()) throw;
            warnings.emplace_back(fault.what());
        }
    }
    return textures;
}

/// What a level of these textures would not show as meant.
void warn_of(std::vector<MipTexture> textures, TextureWarnings& warnings) {
    Level level;
    level.textures.assign(std::make_move_iterator(textures.begin()), std::make_move_iterator(textures.end()));
    TextureAnimations(level, warnings);
    for (const MipTexture& texture : level.textures)
        if (material_of_texture(texture.name) == Material::Sky && !is_layered_sky(texture.width, texture.height))
            warnings.push_back("sky '" + texture.name + "': " + std::to_string(texture.width) + "x" +
                               std::to_string(texture.height) +
                               ", expected two squares side by side, such as 256x128; it is of one colour");
}

std::vector<MipTexture> textures_of_archive(std::span<const std::uint8_t> file, TextureWarnings& warnings) {
    const auto begins_as = [&](const BspFormat& format) {
        return file.size() >= 4 && little_endian_u32(file.data()) == format.version;
    };
    if (std::any_of(kBspFormats.begin(), kBspFormats.end(), begins_as)) return read_bsp_textures(file);
    if (file.empty() || file[0] != 'W')
        throw InputError("header", "of another kind of file, expected a WAD2 or a level");
    std::vector<MipTexture> textures;
    for (const WadTexture& texture : read_wad(file, &warnings)) {
        try {
            textures.push_back(parse_miptex(texture.miptex));
            if (!has_own_name(texture)) textures.back().name = texture.name;
        } catch (const InputError& fault) {
            warnings.push_back(fault.where + ": " + fault.what());
        }
    }
    if (textures.empty() && !warnings.empty())
        throw InputError("textures", "none can be read, expected one or more; " + warnings.front());
    return textures;
}

/// The sums over a block of texels. Holes have no colour.
struct BlockSum {
    int red = 0, green = 0, blue = 0, coloured = 0, fullbright = 0, holes = 0;

    void add(std::uint8_t index, const Palette& palette) {
        const Rgb8 colour = palette.colours[index];
        red += colour.red;
        green += colour.green;
        blue += colour.blue;
        ++coloured;
        if (index >= kFirstFullbright) ++fullbright;
    }
    std::uint8_t mean(int sum) const { return static_cast<std::uint8_t>((sum + coloured / 2) / coloured); }
    Rgb8 mean_colour() const { return {mean(red), mean(green), mean(blue)}; }
    bool glows() const { return 2 * fullbright >= coloured; }
    bool is_hole() const { return holes >= coloured; }
};

BlockSum sum_block(const MipTexture& texture, const Palette& palette, int left, int top, int size) {
    BlockSum sum;
    for (int y = top; y < top + size; ++y)
        for (int x = left; x < left + size; ++x) {
            const std::uint8_t index = item(texture.mips[0], y * texture.width + x);
            if (index == kHole && has_holes(texture.name))
                ++sum.holes;
            else
                sum.add(index, palette);
        }
    return sum;
}

std::vector<std::uint8_t> shrink(const MipTexture& texture, const Palette& palette, int level) {
    const int size = 1 << level;
    const ColourRange fullbright{kFirstFullbright, has_holes(texture.name) ? kHole : 256};
    std::vector<std::uint8_t> texels;
    for (int top = 0; top < texture.height; top += size)
        for (int left = 0; left < texture.width; left += size) {
            const BlockSum sum = sum_block(texture, palette, left, top, size);
            const ColourRange range = sum.glows() ? fullbright : kOrdinaryColours;
            texels.push_back(sum.is_hole() ? kHole : nearest_colour(palette, sum.mean_colour(), range));
        }
    return texels;
}

}  // namespace

MipTexture picture_texture(const std::string& path, std::span<const std::uint8_t> bytes, const Palette& palette,
                           PngColours colours) {
    return naming_file(path, [&] {
        const std::string name = texture_name_of_file(path);
        check_texture_name(name);
        const PngImage image = decode_picture(bytes);
        check_texture_size(image.width_px, image.height_px, "image");
        return make_mip_texture(name, image.width_px, image.height_px, texels_of(image, name, palette, colours),
                                palette);
    });
}

Dither parse_dither(const std::string& text) {
    constexpr std::array<std::string_view, 2> kNames{"none", "floyd-steinberg"};
    return static_cast<Dither>(parse_choice("--dither", text, kNames));
}

std::vector<std::string> pictures_in(const std::string& folder) {
    constexpr std::array<std::string_view, 5> kEndings{".png", ".tga", ".jpg", ".jpeg", ".bmp"};
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string ending = lower_case(entry.path().extension().string());
        const bool is_picture = std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
        if (is_picture && entry.is_regular_file()) files.push_back(entry.path().string());
    }
    if (files.empty()) throw FileError(folder, "folder", "has no pictures, expected PNG, TGA, JPEG or BMP files");
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::uint8_t> packed_textures(const std::vector<std::string>& picture_paths,
                                          const std::vector<std::string>& glowing, const Palette& palette,
                                          Dither dither, TextureWarnings& warnings) {
    return write_wad(read_pictures(picture_paths, glowing, palette, dither, warnings));
}

TextureWarnings pack_textures(const std::vector<std::string>& paths, const std::vector<std::string>& glowing,
                              const std::string& wad_path, const Palette& palette, Dither dither) {
    const std::vector<std::string> pictures = files_of_paths(paths);
    const std::map<std::string, std::string> files = files_by_name(pictures);
    for (const std::string& name : glowing)
        if (!files.contains(lower_case(name)))
            throw UsageError("--glow: '" + name + "', expected the name of one of the textures");
    check_writable(wad_path);
    check_replaces_only("-o", wad_path, "WAD", {"WAD2"});
    TextureWarnings warnings;
    std::vector<MipTexture> textures = read_pictures(pictures, glowing, palette, dither, warnings);
    write_file(wad_path, write_wad(textures));
    warn_of(std::move(textures), warnings);
    return warnings;
}

TextureWarnings unpack_textures(const std::string& archive_path, const std::string& folder, const Palette& palette) {
    TextureWarnings warnings;
    const auto textures = read_parsed(
        archive_path, [&](std::span<const std::uint8_t> bytes) { return textures_of_archive(bytes, warnings); });
    std::map<std::string, const MipTexture*> files;
    for (const MipTexture& texture : textures) {
        const std::string file = file_of_texture_name(texture.name);
        if (!texture.is_missing && !files.emplace(file, &texture).second)
            warnings.push_back("texture '" + texture.name + "': is the second one for the file '" + file +
                               "', expected one for each");
    }
    make_folder(folder);
    for (const auto& [file, texture] : files)
        write_file((std::filesystem::path(folder) / file).string(),
                   encode_indexed_png(texture->mips[0], texture->width, texture->height, palette));
    return warnings;
}

std::string file_of_texture_name(const std::string& name) {
    std::string file = name;
    if (!file.empty() && file[0] == '*') file[0] = '#';
    for (char& letter : file)
        if (letter == '/' || letter == '\\') letter = '_';
    return file + ".png";
}

std::vector<std::uint8_t> make_ramp_sheet(const Palette& palette) {
    constexpr std::int32_t kWidth_px = Colormap::kShades * kRampCellWidth_px, kHeight_px = 256 * kRampCellHeight_px;
    const Colormap colormap = make_colormap(palette);
    std::vector<std::uint8_t> pixels;
    for (std::int32_t y = 0; y < kHeight_px; ++y)
        for (std::int32_t x = 0; x < kWidth_px; ++x)
            pixels.push_back(item(item(colormap.shades, x / kRampCellWidth_px), y / kRampCellHeight_px));
    return encode_indexed_png(pixels, kWidth_px, kHeight_px, palette);
}

MipTexture make_mip_texture(const std::string& name, std::int32_t width, std::int32_t height,
                            std::vector<std::uint8_t> texels, const Palette& palette) {
    MipTexture texture{name, width, height, {std::move(texels)}};
    for (int level = 1; level < 4; ++level) item(texture.mips, level) = shrink(texture, palette, level);
    return texture;
}

}  // namespace oblong
