#include "tools/texture/wad.h"

namespace oblong {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::size_t kNameBytes = 16, kMiptexHeaderBytes = 40, kWadHeaderBytes = 12;

void append_u32(Bytes& bytes, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void append_name(Bytes& bytes, const std::string& name) {
    for (std::size_t at = 0; at < kNameBytes; ++at) {
        bytes.push_back(at + 1 < kNameBytes && at < name.size() ? static_cast<std::uint8_t>(name[at]) : 0);
    }
}

Bytes miptex_lump(const MipTexture& texture) {
    Bytes lump;
    append_name(lump, texture.name);
    append_u32(lump, static_cast<std::size_t>(texture.width));
    append_u32(lump, static_cast<std::size_t>(texture.height));
    std::size_t offset = kMiptexHeaderBytes;
    for (const auto& mip : texture.mips) {
        append_u32(lump, offset);
        offset += mip.size();
    }
    for (const auto& mip : texture.mips) lump.insert(lump.end(), mip.begin(), mip.end());
    return lump;
}

void append_directory_entry(Bytes& directory, std::size_t offset, std::size_t size, const std::string& name) {
    append_u32(directory, offset);
    append_u32(directory, size);
    append_u32(directory, size);
    constexpr std::uint8_t kMiptexType = 'D', kNotCompressed = 0;
    directory.insert(directory.end(), {kMiptexType, kNotCompressed, 0, 0});
    append_name(directory, name);
}

}  // namespace

std::vector<std::uint8_t> write_wad(std::span<const MipTexture> textures) {
    Bytes lumps, directory;
    for (const MipTexture& texture : textures) {
        const Bytes lump = miptex_lump(texture);
        append_directory_entry(directory, kWadHeaderBytes + lumps.size(), lump.size(), texture.name);
        lumps.insert(lumps.end(), lump.begin(), lump.end());
    }
    Bytes file{'W', 'A', 'D', '2'};
    append_u32(file, textures.size());
    append_u32(file, kWadHeaderBytes + lumps.size());
    file.insert(file.end(), lumps.begin(), lumps.end());
    file.insert(file.end(), directory.begin(), directory.end());
    return file;
}

}  // namespace oblong
