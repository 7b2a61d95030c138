#include "tools/texture/texture_name.h"

#include <filesystem>

#include "engine/base/input_error.h"

namespace oblong {

std::string texture_name_of_file(const std::string& path) {
    constexpr std::size_t kLongestName = 15;
    std::string name = std::filesystem::path(path).stem().string();
    if (name.empty() || name.size() > kLongestName) {
        throw InputError(
            "name", "'" + name + "' has " + std::to_string(name.size()) + " characters, a texture's name has 1 to 15");
    }
    if (name[0] == '#') name[0] = '*';
    return name;
}

std::string file_of_texture_name(const std::string& name) {
    std::string file = name;
    if (!file.empty() && file[0] == '*') file[0] = '#';
    for (char& letter : file) {
        if (letter == '/' || letter == '\\') letter = '_';
    }
    return file + ".png";
}

}  // namespace oblong
