#include "tools/texture/texture_files.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/base/input_error.h"
#include "engine/platform/replace_file.h"
#include "tools/png/indexed_png.h"
#include "tools/texture/image_read.h"
#include "tools/texture/mipmaps.h"
#include "tools/texture/texture_name.h"
#include "tools/texture/wad.h"

namespace oblong {
namespace {

/// Runs `work`; an error in it gets the file's name before its place.
template <class Work>
auto naming_file(const std::string& path, Work work) {
    try {
        return work();
    } catch (const InputError& error) {
        throw InputError(path + ": " + error.where, error.what());
    }
}

bool is_texture_size(std::int32_t size) {
    return size > 0 && size <= 4096 && size % 16 == 0;
}

}  // namespace

std::vector<std::uint8_t> read_whole_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in || std::filesystem::is_directory(path)) throw InputError(path + ": file", "cannot be read");
    return {std::istreambuf_iterator<char>(in), {}};
}

void write_whole_file(const std::string& path, const std::vector<std::uint8_t>& bytes) {
    replace_file(path, bytes);
}

Palette read_palette_file(const std::string& path) {
    return naming_file(path, [bytes = read_whole_file(path)] { return read_palette(bytes); });
}

MipTexture read_png_texture(const std::string& path, const Palette& palette) {
    const auto bytes = read_whole_file(path);
    return naming_file(path, [&] {
        const std::string name = texture_name_of_file(path);
        IndexedImage image = read_png_as_indexed(bytes, palette);
        if (!is_texture_size(image.width) || !is_texture_size(image.height)) {
            throw InputError("image", std::to_string(image.width) + "x" + std::to_string(image.height) +
                                          ", expected multiples of 16 up to 4096");
        }
        return make_mip_texture(name, image.width, image.height, std::move(image.pixels), palette);
    });
}

void pack_textures(const std::vector<std::string>& png_paths, const std::string& wad_path, const Palette& palette) {
    std::vector<MipTexture> textures;
    for (const std::string& path : png_paths) textures.push_back(read_png_texture(path, palette));
    write_whole_file(wad_path, write_wad(textures));
}

void unpack_textures(const std::string& archive_path, const std::string& folder, const Palette& palette) {
    const auto bytes = read_whole_file(archive_path);
    const auto textures = naming_file(archive_path, [&] { return read_textures(bytes); });
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) throw InputError(folder + ": folder", "cannot be made: " + failure.message());
    for (const MipTexture& texture : textures) {
        const std::string path = (std::filesystem::path(folder) / file_of_texture_name(texture.name)).string();
        write_indexed_png(path, texture.mips[0], texture.width, texture.height, palette);
    }
}

}  // namespace oblong
