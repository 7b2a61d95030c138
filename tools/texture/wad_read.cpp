#include <algorithm>
#include <string_view>

#include "engine/base/input_error.h"
#include "tools/texture/wad.h"

namespace oblong {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// `size` bytes at `offset`, if the file has them.
Bytes checked_part(Bytes file, std::size_t offset, std::size_t size, const std::string& what) {
    if (offset > file.size() || size > file.size() - offset) {
        throw InputError(what, std::to_string(size) + " bytes at offset " + std::to_string(offset) +
                                   " lie outside of the " + std::to_string(file.size()) + " that there are");
    }
    return file.subspan(offset, size);
}

std::uint32_t u32_at(Bytes file, std::size_t offset, const std::string& what) {
    const Bytes bytes = checked_part(file, offset, 4, what);
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8 | static_cast<std::uint32_t>(bytes[2]) << 16 |
           static_cast<std::uint32_t>(bytes[3]) << 24;
}

std::string name_at(Bytes lump) {
    const Bytes bytes = checked_part(lump, 0, 16, "texture name");
    const auto end = std::find(bytes.begin(), bytes.end(), 0);
    return {bytes.begin(), end};
}

/// `lump` begins with the miptex and may go on after it.
MipTexture read_miptex(Bytes lump) {
    MipTexture texture;
    texture.name = name_at(lump);
    const std::string where = "texture " + texture.name;
    const std::uint32_t width = u32_at(lump, 16, where), height = u32_at(lump, 20, where);
    constexpr std::uint32_t kLargest = 4096;
    const bool is_sane = width > 0 && height > 0 && width <= kLargest && height <= kLargest;
    if (!is_sane || width % 16 != 0 || height % 16 != 0) {
        throw InputError(
            where, std::to_string(width) + "x" + std::to_string(height) + ", expected multiples of 16 up to 4096");
    }
    texture.width = static_cast<std::int32_t>(width);
    texture.height = static_cast<std::int32_t>(height);
    for (std::size_t level = 0; level < 4; ++level) {
        const std::size_t size = static_cast<std::size_t>(width >> level) * (height >> level);
        const Bytes texels = checked_part(lump, u32_at(lump, 24 + 4 * level, where), size, where);
        texture.mips[level].assign(texels.begin(), texels.end());
    }
    return texture;
}

std::vector<MipTexture> read_wad(Bytes file) {
    const std::uint32_t count = u32_at(file, 4, "header"), directory = u32_at(file, 8, "header");
    constexpr std::size_t kEntryBytes = 32, kTypeOffset = 12;
    std::vector<MipTexture> textures;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Bytes entry = checked_part(file, directory + i * kEntryBytes, kEntryBytes, "directory");
        if (entry[kTypeOffset] != 'D') continue;
        const std::uint32_t offset = u32_at(entry, 0, "directory"), size = u32_at(entry, 4, "directory");
        textures.push_back(read_miptex(checked_part(file, offset, size, "lump " + name_at(entry.subspan(16)))));
    }
    return textures;
}

std::vector<MipTexture> read_bsp_textures(Bytes file) {
    constexpr std::size_t kTextureLump = 2;
    const std::size_t entry = 4 + kTextureLump * 8;
    const Bytes lump =
        checked_part(file, u32_at(file, entry, "header"), u32_at(file, entry + 4, "header"), "lump textures");
    std::vector<MipTexture> textures;
    const std::uint32_t count = lump.empty() ? 0 : u32_at(lump, 0, "lump textures");
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t offset = u32_at(lump, 4 + std::size_t{4} * i, "lump textures");
        constexpr std::uint32_t kNone = 0xffffffff;
        if (offset == kNone) continue;
        const Bytes miptex =
            checked_part(lump, offset, lump.size() - std::min<std::size_t>(offset, lump.size()), "lump textures");
        constexpr std::size_t kFirstMipOffset = 24;
        const bool has_texels = u32_at(miptex, kFirstMipOffset, "lump textures") != 0;
        if (has_texels) textures.push_back(read_miptex(miptex));
    }
    return textures;
}

bool begins_with(Bytes file, std::string_view letters) {
    return file.size() >= letters.size() && std::equal(letters.begin(), letters.end(), file.begin());
}

}  // namespace

std::vector<MipTexture> read_textures(std::span<const std::uint8_t> file) {
    using namespace std::string_view_literals;
    if (begins_with(file, "WAD2")) return read_wad(file);
    for (const std::string_view version : {"\x1d\0\0\0"sv, "BSP2"sv, "2PSB"sv}) {
        if (begins_with(file, version)) return read_bsp_textures(file);
    }
    throw InputError("header", "neither a WAD2 nor a Quake BSP (29, BSP2 or 2PSB)");
}

}  // namespace oblong
