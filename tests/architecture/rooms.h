#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Which room may include which: the arrows of the project, all pointing down.
namespace oblong::test {

struct Room {
    std::string folder;                ///< from the project's root, with no slash at its end
    std::vector<std::string> depends;  ///< folders of rooms; what those depend on comes with them
    bool operator==(const Room&) const = default;
};

/// The rooms, top to bottom. engine/CMakeLists.txt says the same of engine/ to the linker.
const std::vector<Room>& project_rooms();

/// The room with the longest folder that holds `path`; null if none does.
const Room* find_room(const std::vector<Room>& rooms, std::string_view path);

/// Whether a file of `from` may include one of `to`: its own room, one that it depends on, or one that those do.
bool may_include(const std::vector<Room>& rooms, const Room& from, const Room& to);

/// The rooms that a CMake file declares by oblong_room(NAME FOLDER DEPENDS ...), with `prefix` before every folder.
std::vector<Room> parse_cmake_rooms(const std::string& cmake, const std::string& prefix);

}  // namespace oblong::test
