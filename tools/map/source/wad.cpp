#include "tools/map/source/wad.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "engine/base/input_error.h"

namespace oblong::map {
namespace {

constexpr std::size_t kEntrySize = 32, kNameSize = 16, kMiptexHeaderSize = 40;
constexpr char kMiptexType = 'D';
constexpr std::string_view kFrames = "0123456789abcdefghij";

std::uint32_t read_u32(const std::string& bytes, std::size_t offset, const std::string& where) {
    if (offset + 4 > bytes.size()) throw InputError(where, "the file ends, expected 4 more bytes");
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
    return value;
}

std::string name_at(const std::string& bytes, std::size_t offset) {
    std::string name(bytes.data() + offset, strnlen(bytes.data() + offset, kNameSize));
    std::transform(name.begin(), name.end(), name.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 32) : letter;
    });
    return name;
}

const std::string* find_in(const std::vector<Wad>& wads, const std::string& name) {
    for (const Wad& wad : wads) {
        if (const std::string* found = wad.find(name)) return found;
    }
    return nullptr;
}

bool is_animated(const std::string& name) {
    return name.size() > 2 && name[0] == '+';
}

}  // namespace

Wad::Wad(const std::string& bytes) {
    if (bytes.substr(0, 4) != "WAD2") throw InputError("header", "no WAD2 file, expected it to begin with 'WAD2'");
    const std::size_t count = read_u32(bytes, 4, "header"), directory = read_u32(bytes, 8, "header");
    if (directory > bytes.size() || count > (bytes.size() - directory) / kEntrySize)
        throw InputError("header", "the directory reaches beyond the file's end");
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t entry = directory + i * kEntrySize;
        const std::string where = "directory entry " + std::to_string(i);
        if (bytes[entry + 12] != kMiptexType) continue;
        const std::size_t offset = read_u32(bytes, entry, where), size = read_u32(bytes, entry + 8, where);
        if (size < kMiptexHeaderSize || offset > bytes.size() || size > bytes.size() - offset)
            throw InputError(where, "the texture reaches beyond the file's end");
        textures_.emplace(name_at(bytes, entry + 16), bytes.substr(offset, size));
    }
}

const std::string* Wad::find(const std::string& name) const {
    const auto found = textures_.find(name);
    return found == textures_.end() ? nullptr : &found->second;
}

std::vector<std::string> collect_textures(const std::vector<TextureUse>& uses, const std::vector<Wad>& wads) {
    std::vector<std::string> textures, names;
    for (const TextureUse& use : uses) {
        const std::string* texture = find_in(wads, use.name);
        if (texture == nullptr)
            throw InputError("line " + std::to_string(use.line),
                             "texture '" + use.name + "' is in none of the WAD files, expected one (see --wad)");
        textures.push_back(*texture);
        names.push_back(use.name);
    }
    for (const TextureUse& use : uses) {
        for (const char frame : kFrames) {
            std::string name = use.name;
            if (!is_animated(name)) break;
            name[1] = frame;
            const std::string* texture = find_in(wads, name);
            if (texture == nullptr || std::find(names.begin(), names.end(), name) != names.end()) continue;
            textures.push_back(*texture);
            names.push_back(name);
        }
    }
    return textures;
}

}  // namespace oblong::map
