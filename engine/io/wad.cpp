#include "engine/io/wad.h"

#include <algorithm>
#include <iterator>

#include "engine/base/little_endian.h"
#include "engine/base/table.h"
#include "engine/base/text.h"

namespace oblong {
namespace {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;
constexpr std::size_t kNameBytes = 16, kMiptexHeaderBytes = 40, kWadHeaderBytes = 12, kEntryBytes = 32;
constexpr std::uint8_t kMiptexType = 'D';
constexpr ByteView::value_type kSignature[]{'W', 'A', 'D', '2'};

/// `size` bytes at `offset`. Throws InputError if they are not all there.
ByteView part_of(ByteView bytes, std::size_t offset, std::size_t size, const std::string& what) {
    if (offset > bytes.size() || size > bytes.size() - offset) {
        throw InputError(what, std::to_string(size) + " bytes at offset " + std::to_string(offset) +
                                   ", expected them within the " + std::to_string(bytes.size()) + " that there are");
    }
    return bytes.subspan(offset, size);
}

std::uint32_t u32_at(ByteView bytes, std::size_t offset, const std::string& what) {
    return little_endian_u32(part_of(bytes, offset, 4, what).data());
}

std::string name_at(ByteView bytes, std::size_t offset) {
    const ByteView name = part_of(bytes, offset, kNameBytes, "texture name");
    return {name.begin(), std::find(name.begin(), name.end(), 0)};
}

WadTexture wad_texture(ByteView file, ByteView entry) {
    const std::string name = name_at(entry, kNameBytes), where = "texture '" + name + "'";
    const ByteView miptex = part_of(file, u32_at(entry, 0, where), u32_at(entry, 4, where), where);
    part_of(miptex, 0, kMiptexHeaderBytes, where);
    return {name, miptex};
}

void append_u32(Bytes& bytes, std::size_t value) {
    append_little_endian(bytes, static_cast<std::uint32_t>(value));
}

void append_name(Bytes& bytes, const std::string& name) {
    for (std::size_t at = 0; at < kNameBytes; ++at) {
        bytes.push_back(at + 1 < kNameBytes && at < name.size() ? static_cast<std::uint8_t>(name[at]) : 0);
    }
}

Bytes miptex_lump(const MipTexture& texture) {
    Bytes lump;
    append_name(lump, texture.name);
    append_u32(lump, as_size(texture.width));
    append_u32(lump, as_size(texture.height));
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
    constexpr std::uint8_t kNotCompressed = 0;
    directory.insert(directory.end(), {kMiptexType, kNotCompressed, 0, 0});
    append_name(directory, name);
}

}  // namespace

void check_texture_size(std::int64_t width, std::int64_t height, const std::string& where) {
    const auto is_size = [](std::int64_t size) { return size > 0 && size <= 4096 && size % 16 == 0; };
    if (is_size(width) && is_size(height)) return;
    throw InputError(where,
                     std::to_string(width) + "x" + std::to_string(height) + ", expected multiples of 16 up to 4096");
}

std::vector<WadTexture> read_wad(std::span<const std::uint8_t> file, std::vector<std::string>* faults) {
    if (file.size() < sizeof kSignature || !std::equal(std::begin(kSignature), std::end(kSignature), file.begin()))
        throw InputError("header", "not a WAD2 file, expected it to begin with 'WAD2'");
    const std::uint32_t count = u32_at(file, 4, "header"), start = u32_at(file, 8, "header");
    if (const std::size_t most = file.size() / kEntryBytes; count > most)
        throw InputError("directory", std::to_string(count) + " entries, expected at most " + std::to_string(most) +
                                          " of 32 bytes each");
    const ByteView directory = part_of(file, start, count * kEntryBytes, "directory");
    std::vector<WadTexture> textures;
    std::size_t bytes = 0;  // textures may share theirs, but who keeps a copy of each has a bound
    for (std::size_t i = 0; i < count; ++i) {
        const ByteView entry = directory.subspan(i * kEntryBytes, kEntryBytes);
        constexpr std::size_t kTypeOffset = 12;
        if (entry[kTypeOffset] != kMiptexType) continue;
        try {
            textures.push_back(wad_texture(file, entry));
        } catch (const InputError& fault) {
            if (faults == nullptr) throw;
            faults->push_back(fault.where + ": " + fault.what());
            continue;
        }
        bytes += textures.back().miptex.size();
        if (bytes > 4 * file.size())
            throw InputError("directory", "textures of " + std::to_string(bytes) +
                                              " bytes or more, expected at most 4 " + "times the file's " +
                                              std::to_string(file.size()));
    }
    return textures;
}

bool has_own_name(const WadTexture& texture) {
    return lower_case(name_at(texture.miptex, 0)) == lower_case(texture.name);
}

MipTexture parse_miptex(std::span<const std::uint8_t> miptex) {
    MipTexture texture;
    texture.name = name_at(miptex, 0);
    const std::string where = "texture '" + texture.name + "'";
    const std::uint32_t width = u32_at(miptex, 16, where), height = u32_at(miptex, 20, where);
    check_texture_size(width, height, where);
    texture.width = static_cast<std::int32_t>(width);
    texture.height = static_cast<std::int32_t>(height);
    for (std::size_t level = 0; level < 4; ++level) {
        const std::size_t size = std::size_t{width >> level} * (height >> level);
        const std::uint32_t offset = u32_at(miptex, 24 + 4 * level, where);
        if (offset < kMiptexHeaderBytes)
            throw InputError(where, "mip level " + std::to_string(level) + " at offset " + std::to_string(offset) +
                                        ", expected 40 or more, behind its header");
        const ByteView texels = part_of(miptex, offset, size, where);
        texture.mips[level].assign(texels.begin(), texels.end());
    }
    return texture;
}

std::vector<std::uint8_t> write_wad(std::span<const MipTexture> textures) {
    Bytes lumps, directory;
    for (const MipTexture& texture : textures) {
        const Bytes lump = miptex_lump(texture);
        append_directory_entry(directory, kWadHeaderBytes + lumps.size(), lump.size(), texture.name);
        lumps.insert(lumps.end(), lump.begin(), lump.end());
    }
    Bytes file(std::begin(kSignature), std::end(kSignature));
    append_u32(file, textures.size());
    append_u32(file, kWadHeaderBytes + lumps.size());
    file.insert(file.end(), lumps.begin(), lumps.end());
    file.insert(file.end(), directory.begin(), directory.end());
    return file;
}

}  // namespace oblong
