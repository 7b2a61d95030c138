#pragma once

#include <string>
#include <vector>

#include "tests/architecture/rooms.h"

namespace oblong::test {

struct SourceFile {
    std::string path;  ///< from the project's root
    std::string text;
};

/// One line of English for every #include that breaks a rule:
///   - quoted names are paths from the project's root, in a room that the includer's room may include;
///   - only engine/platform/sdl/ includes SDL;
///   - engine/ outside files/ and platform/ has no files, clock, threads or randomness, and no header that old
///     WebAssembly compilers lack.
std::vector<std::string> find_bad_includes(const std::vector<Room>& rooms, const std::vector<SourceFile>& files);

/// One line for every path of the repository that does not belong at its top level.
std::vector<std::string> find_strays(const std::vector<std::string>& paths);

}  // namespace oblong::test
