#pragma once

#include <string>

namespace oblong {

/// "any/folder/#water.png" -> "*water": the file's name without folder and ending, a leading '#' standing for the '*'
/// of liquids, which file systems dislike. Throws InputError unless 1 to 15 characters are left.
std::string texture_name_of_file(const std::string& path);

/// "*water" -> "#water.png". Slashes, which a name in a broken file may hold, become '_'.
std::string file_of_texture_name(const std::string& name);

}  // namespace oblong
