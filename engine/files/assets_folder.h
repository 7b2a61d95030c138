#pragma once

#include <string>

namespace oblong {

/// The folder of the running program. `called_as`: argv[0], for systems that do not say which program runs.
std::string program_folder(const char* called_as);

/// The folder of the project's own level, palette and sounds: beside the folder of the running program in a build
/// tree (build/bin, build/assets), wherever that was moved to, or where `cmake --install` puts it
/// (PREFIX/share/oblong). `called_as` as in program_folder(). Throws FileError where neither is there.
std::string assets_folder(const char* called_as);

}  // namespace oblong
