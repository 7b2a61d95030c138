#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace oblong::test {

/// Which room may include which: the arrows of the project, all pointing down.
struct Room {
    std::string folder;                ///< from the project's root, with no slash at its end
    std::vector<std::string> depends;  ///< folders of rooms; what those depend on comes with them
};

/// The rooms: those that the rooms.cmake of engine/ and game/ declare by oblong_room(NAME FOLDER DEPENDS ...), and
/// those that are linked otherwise. Throws std::out_of_range if one depends on a room that comes after it.
std::vector<Room> project_rooms(const std::string& root);

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

/// The files of `files` that include themselves through others, and those on a way from one such file to another. Which
/// of them is included first decides whether it compiles.
std::vector<std::string> find_include_cycles(const std::vector<SourceFile>& files);

/// One line for every path of the repository that does not belong at its top level.
std::vector<std::string> find_strays(const std::vector<std::string>& paths);

/// One line for every function that a header of engine/ declares and no code of `files` uses: neither the engine, nor
/// the game, nor a tool other than the gallery and the probe, which show what they like. Names are compared, not
/// meanings: a name that another function has in use passes. Functions of engine/methods are for the gallery, the probe
/// and tests, so that they are not asked for, but what they use counts as used.
std::vector<std::string> find_unused_functions(const std::vector<SourceFile>& files);

}  // namespace oblong::test
