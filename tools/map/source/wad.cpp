#include "tools/map/source/wad.h"

#include <algorithm>

#include "engine/base/input_error.h"
#include "engine/files/wad.h"

namespace oblong::map {
namespace {

constexpr std::string_view kFrames = "0123456789abcdefghij";

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
    const std::span file(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    for (const WadTexture& texture : read_wad(file))
        textures_.emplace(lookup_name(texture.name), std::string(texture.miptex.begin(), texture.miptex.end()));
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
