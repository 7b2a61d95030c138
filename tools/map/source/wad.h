#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/map/source/textures.h"

namespace oblong::map {

/// The textures of a WAD2 file: each as the bytes of its miptex, by its name in lower case.
class Wad {
  public:
    /// Reads the bytes of a file, throwing InputError.
    explicit Wad(const std::string& bytes);

    /// The miptex's bytes, or null.
    const std::string* find(const std::string& name) const;

  private:
    std::map<std::string, std::string> textures_;
};

/// The bytes of each named texture, from the first WAD that has it, followed by the other frames of the animated ones
/// ("+0name": those of +0 to +9 and +a to +j that there are). Throws InputError naming the texture and its map line if
/// there is none.
std::vector<std::string> collect_textures(const std::vector<TextureUse>& uses, const std::vector<Wad>& wads);

}  // namespace oblong::map
