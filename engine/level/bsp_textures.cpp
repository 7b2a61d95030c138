#include "engine/base/table.h"
#include "engine/level/bsp_file.h"

namespace oblong {

namespace {

constexpr std::int32_t kNameSize = 16;
constexpr std::int64_t kOffsetsStart = 24, kHeaderSize = 40;  ///< of the mip levels' offsets; of all before the texels
constexpr std::int32_t kMissingSize = 64;                     ///< texels a side of the checkerboard
constexpr std::uint8_t kMissingLight = 15, kMissingDark = 0;  ///< white and black in Quake's palette
constexpr std::int32_t kMaxTextures = 8192;  ///< a missing one is 4 bytes in the file, many in memory; Quake: 512
constexpr std::uint32_t kMaxTextureSize = 1 << 14;  ///< texels a side: products of sizes fit 32 bits

std::string read_name(LumpReader& in) {
    const auto bytes = in.read_bytes(kNameSize);
    std::string name;
    for (const std::uint8_t letter : bytes) {
        if (letter == 0) break;
        name += static_cast<char>(letter);
    }
    return name;
}

/// Replaces a texture without texels, or of a size that cannot be drawn: squares of an eighth of its size, at every mip
/// level.
MipTexture make_checkerboard(std::string name) {
    MipTexture texture{std::move(name), kMissingSize, kMissingSize, {}, true};
    std::int32_t size = kMissingSize;
    for (auto& mip : texture.mips) {
        for (std::int32_t texel = 0; texel < size * size; ++texel) {
            const std::int32_t column = texel % size * 8 / size, row = texel / size * 8 / size;
            mip.push_back((column + row) % 2 == 0 ? kMissingLight : kMissingDark);
        }
        size /= 2;
    }
    return texture;
}

/// 0, 24 ...: Quake stops at such a texture, later engines draw the others.
constexpr bool is_texture_size(std::uint32_t texels) {
    return texels > 0 && texels <= kMaxTextureSize && texels % 16 == 0;
}

/// `texels_left`: how many bytes textures may still take; they overlap only in files made to waste memory.
MipTexture read_texture(LumpReader& in, std::int64_t start, std::int64_t& texels_left) {
    in.seek(start);
    MipTexture texture;
    texture.name = read_name(in);
    const std::uint32_t width = in.read_u32(), height = in.read_u32();
    std::array<std::uint32_t, 4> offsets{};
    for (std::uint32_t& offset : offsets) offset = in.read_u32();
    if (offsets == std::array<std::uint32_t, 4>{} || !is_texture_size(width) || !is_texture_size(height))
        return make_checkerboard(texture.name);
    texture.width = static_cast<std::int32_t>(width);
    texture.height = static_cast<std::int32_t>(height);

    for (int mip = 0; mip < 4; ++mip) {
        const auto i = as_size(mip);
        const std::int64_t size = std::int64_t{texture.width >> mip} * (texture.height >> mip);
        if (offsets[i] < kHeaderSize) {
            in.seek(start + kOffsetsStart + 4 * mip);
            in.fail("mip level " + std::to_string(mip) + " at offset " + std::to_string(offsets[i]) + " of texture '" +
                    texture.name + "', expected 40 or more, behind its header");
        }
        in.seek(start + offsets[i]);
        const auto texels = in.read_bytes(size);
        texels_left -= size;
        if (texels_left < 0)
            in.fail("texture '" + texture.name + "' overlaps others, expected each to have its own bytes");
        texture.mips[i].assign(texels.begin(), texels.end());
    }
    return texture;
}

}  // namespace

Table<MipTexture> read_textures(const BspFile& file) {
    LumpReader in(file, Lump::Textures);
    Table<MipTexture> textures;
    if (in.size() == 0) return textures;

    const std::int32_t count = in.read_i32();
    if (count > kMaxTextures) in.fail(std::to_string(count) + " textures, expected 8192 at most");
    in.check_extent(0, std::int64_t{count} * 4, in.size() - 4, "bytes of texture offsets");
    std::int64_t texels_left = in.size();
    for (std::int32_t i = 0; i < count; ++i) {
        in.seek(4 + std::int64_t{i} * 4);
        const std::int32_t start = in.read_i32();
        textures.push_back(start == -1 ? make_checkerboard("") : read_texture(in, start, texels_left));
    }
    return textures;
}

std::vector<std::string> texture_warnings(const Level& level) {
    std::vector<std::string> warnings;
    for (const MipTexture& texture : level.textures)
        if (texture.is_missing)
            warnings.push_back("texture '" + texture.name +
                               "' is shown as a checkerboard: expected texels, and sides of 16, 32 ... to 16384");
    return warnings;
}

}  // namespace oblong
