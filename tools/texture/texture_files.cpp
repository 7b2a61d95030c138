#include "tools/texture/texture_files.h"

#include <filesystem>

#include "engine/platform/files.h"
#include "tools/png/indexed_png.h"
#include "tools/texture/image_read.h"
#include "tools/texture/mipmaps.h"
#include "tools/texture/texture_name.h"
#include "tools/texture/wad.h"

namespace oblong {
namespace {

bool is_texture_size(std::int32_t size) {
    return size > 0 && size <= 4096 && size % 16 == 0;
}

}  // namespace

MipTexture read_png_texture(const std::string& path, const Palette& palette) {
    return read_parsed(path, [&](std::span<const std::uint8_t> bytes) {
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
    write_file(wad_path, write_wad(textures));
}

void unpack_textures(const std::string& archive_path, const std::string& folder, const Palette& palette) {
    const auto textures = read_parsed(archive_path, read_textures);
    make_folder(folder);
    for (const MipTexture& texture : textures) {
        const std::string path = (std::filesystem::path(folder) / file_of_texture_name(texture.name)).string();
        write_file(path, encode_indexed_png(texture.mips[0], texture.width, texture.height, palette));
    }
}

}  // namespace oblong
