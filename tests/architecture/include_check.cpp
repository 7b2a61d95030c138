#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "tests/architecture/source_checks.h"

namespace oblong::test {

namespace {

constexpr std::array<std::string_view, 21> kForbiddenInEngine = {
    "format",  "ranges",     "source_location", "stop_token", "thread",   "mutex",   "condition_variable",
    "future",  "chrono",     "ctime",           "time.h",     "fstream",  "sstream", "iostream",
    "ostream", "filesystem", "cstdio",          "stdio.h",    "unistd.h", "random",  "atomic"};

/// Where the engine meets a system or files.
constexpr std::array<std::string_view, 6> kOutside = {"engine/io/",       "engine/pictures/", "engine/models/",
                                                      "engine/programs/", "engine/sound/",    "engine/platform/"};

constexpr std::array<std::string_view, 8> kTopLevel = {"engine", "game",           "tools",     "tests",
                                                       "assets", "CMakeLists.txt", "README.md", "LICENSE"};

struct Include {
    std::string name;
    bool is_quoted = false;
};

/// The include on a line, its name empty if there is none.
Include parse_include(const std::string& line) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') return {};
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) return {};
    const std::size_t open = line.find_first_of("\"<", word);
    if (open == std::string::npos) return {};
    const bool is_quoted = line[open] == '"';
    const std::size_t close = line.find(is_quoted ? '"' : '>', open + 1);
    return {line.substr(open + 1, close - open - 1), is_quoted};
}

bool is_sdl(const std::string& name) {
    return name.starts_with("SDL");
}

/// Of POSIX.
bool is_of_a_system(const std::string& name) {
    constexpr std::array<std::string_view, 8> kHeaders{"unistd.h", "fcntl.h",  "spawn.h",   "signal.h",
                                                       "csignal",  "dirent.h", "pthread.h", "poll.h"};
    return name.starts_with("sys/") || std::find(kHeaders.begin(), kHeaders.end(), name) != kHeaders.end();
}

std::string check_system_include(const std::string& path, const std::string& name) {
    const bool may_ask = path == "engine/io/system.cpp" || path.starts_with("engine/platform/dos/");
    if (is_of_a_system(name) && !may_ask) return "only engine/io/system.cpp asks the system";
    if (is_sdl(name) && !path.starts_with("engine/platform/sdl/")) return "only engine/platform/sdl/ includes SDL";
    if (!path.starts_with("engine/") ||
        std::any_of(kOutside.begin(), kOutside.end(), [&](auto room) { return path.starts_with(room); }))
        return "";
    const bool is_forbidden =
        std::find(kForbiddenInEngine.begin(), kForbiddenInEngine.end(), name) != kForbiddenInEngine.end();
    return is_forbidden ? "the engine does without it, but where it meets a system or files" : "";
}

// The room with the longest folder that holds `path`; null if none does.
const Room* find_room(const std::vector<Room>& rooms, std::string_view path) {
    const Room* best = nullptr;
    for (const Room& room : rooms) {
        if (!path.starts_with(room.folder + "/")) continue;
        if (!best || room.folder.size() > best->folder.size()) best = &room;
    }
    return best;
}

// Whether a file of `from` may include one of `to`: its own room, one that it depends on, or one that those do.
bool may_include(const std::vector<Room>& rooms, const Room& from, const Room& to) {
    if (from.folder == to.folder) return true;
    return std::any_of(from.depends.begin(), from.depends.end(), [&](const std::string& folder) {
        const Room* below = find_room(rooms, folder + "/");
        return below && may_include(rooms, *below, to);
    });
}

/// Of an example: the library's header and the standard library.
std::string check_include_of_example(const Include& include) {
    const bool is_standard = !include.is_quoted && include.name.find_first_of("./") == std::string::npos;
    return is_standard || include.name == "oblong.h" ? "" : "an example uses oblong.h and the standard library alone";
}

std::string check_project_include(const std::vector<Room>& rooms, const Room& from, const std::string& name) {
    const Room* to = find_room(rooms, name);
    if (!to) return "not a path from the project's root into a room";
    return may_include(rooms, from, *to) ? "" : from.folder + " does not depend on " + to->folder;
}

}  // namespace

std::vector<Room> project_rooms(const std::string& root) {
    std::vector<Room> rooms;
    std::map<std::string, std::string> folders;
    for (const std::string top : {"engine/", "game/"}) {
        std::ifstream cmake(root + "/" + top + "rooms.cmake");
        for (std::string line; std::getline(cmake, line);) {
            constexpr std::string_view kOpening = "oblong_room(";
            if (!line.starts_with(kOpening)) continue;
            std::istringstream words(line.substr(kOpening.size(), line.find(')') - kOpening.size()));
            std::string name, folder, word, list;
            words >> name >> folder;
            Room& room = rooms.emplace_back(Room{top + folder, {}});
            while (words >> word)
                if (word == "DEPENDS" || word == "EXTRA_FOLDERS" || word == "EXCEPT" || word == "DESKTOP")
                    list = word;
                else if (list == "DEPENDS")
                    room.depends.push_back(folders.at(word));
            folders[name] = room.folder;
        }
    }
    rooms.insert(rooms.end(),
                 {{"game/dos", {"tools/gallery/program"}},
                  {"game/web", {"tools/gallery/program"}},
                  {"tools/gallery", {"engine/measure", "engine/methods", "engine/pictures", "engine/programs"}},
                  {"tools/gallery/program", {"tools/gallery", "game/program"}},
                  {"tools", {"tools/gallery", "engine/costs", "engine/models", "engine/platform"}}});
    return rooms;
}

std::vector<std::string> find_bad_includes(const std::vector<Room>& rooms, const std::vector<SourceFile>& files) {
    std::vector<std::string> faults;
    for (const SourceFile& file : files) {
        const Room* room = find_room(rooms, file.path);
        const bool is_example = file.path.starts_with("engine/examples/");
        if (!room && !is_example) {
            faults.push_back(file.path + ": in no room");
            continue;
        }
        std::istringstream lines(file.text);
        for (std::string line; std::getline(lines, line);) {
            const Include include = parse_include(line);
            if (include.name.empty()) continue;
            const std::string fault = is_example ? check_include_of_example(include)
                                      : include.is_quoted && !is_sdl(include.name)
                                          ? check_project_include(rooms, *room, include.name)
                                          : check_system_include(file.path, include.name);
            if (!fault.empty()) faults.push_back(file.path + ": includes " + include.name + ": " + fault);
        }
    }
    return faults;
}

std::vector<std::string> find_include_cycles(const std::vector<SourceFile>& files) {
    std::set<std::string> left;
    for (const SourceFile& file : files) left.insert(file.path);
    std::vector<std::pair<std::string, std::string>> pairs;  // includer, included
    for (const SourceFile& file : files) {
        std::istringstream lines(file.text);
        for (std::string line; std::getline(lines, line);)
            if (const Include include = parse_include(line); left.contains(include.name))
                pairs.emplace_back(file.path, include.name);
    }
    for (std::size_t before = left.size() + 1; left.size() < before;) {
        before = left.size();
        std::set<std::string> includers, included;
        for (const auto& [from, to] : pairs)
            if (left.contains(from) && left.contains(to)) {
                includers.insert(from);
                included.insert(to);
            }
        std::erase_if(left,
                      [&](const std::string& path) { return !includers.contains(path) || !included.contains(path); });
    }
    return {left.begin(), left.end()};
}

std::vector<std::string> find_strays(const std::vector<std::string>& paths) {
    std::set<std::string> strays;
    for (const std::string& path : paths) {
        const std::string top = path.substr(0, path.find('/'));
        const bool is_known = std::find(kTopLevel.begin(), kTopLevel.end(), top) != kTopLevel.end();
        if (!is_known && !top.starts_with(".")) strays.insert(top);
    }
    return {strays.begin(), strays.end()};
}

}  // namespace oblong::test
