#pragma once

#include <string>

namespace oblong {

/// The folder of the running program. `called_as`: argv[0], for systems without /proc.
std::string program_folder(const char* called_as);

/// The folder of the project's own level, palette and sounds: in a build tree, beside the folder of the running program
/// (build/bin, build/assets); else where `cmake --install` puts it (PREFIX/share/oblong). `called_as` as in
/// program_folder(). Throws FileError if neither exists.
std::string assets_folder(const char* called_as);

}  // namespace oblong
