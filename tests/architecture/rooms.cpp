#include "tests/architecture/rooms.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace oblong::test {

const std::vector<Room>& project_rooms() {
    static const std::vector<Room> rooms = {
        {"engine/base", {}},
        {"engine/fixed", {"engine/base"}},
        {"engine/math", {"engine/fixed"}},
        {"engine/accuracy", {"engine/fixed"}},
        {"engine/view", {"engine/math", "engine/accuracy"}},
        {"engine/surface", {"engine/accuracy"}},
        {"engine/raster", {"engine/view", "engine/surface"}},
        {"engine/draw", {"engine/view", "engine/surface"}},
        {"engine/level", {"engine/math", "engine/surface"}},
        {"engine/scene", {"engine/raster", "engine/level"}},
        {"engine/visibility", {"engine/scene"}},
        {"engine/effects", {"engine/visibility"}},
        {"engine/mesh", {"engine/scene"}},
        {"engine/frame", {"engine/visibility", "engine/effects", "engine/mesh"}},
        {"engine/methods", {"engine/frame"}},
        {"engine/files", {"engine/frame", "engine/draw"}},
        {"engine/platform", {"engine/view", "engine/surface"}},
        {"engine/platform/sdl", {"engine/platform"}},
        {"engine/library", {"engine/methods", "engine/files", "engine/platform/sdl"}},
        {"game/simulation", {"engine/scene"}},
        {"game/input", {"game/simulation", "engine/platform"}},
        {"game/options", {"game/input", "engine/files"}},
        {"game/level", {"game/simulation", "engine/files"}},
        {"game/saves", {"game/level"}},
        {"game/sound", {"game/simulation", "engine/platform", "engine/files"}},
        {"game/menu", {"game/options"}},
        {"game/view", {"game/options", "game/level"}},
        {"game/lab", {"game/view", "tools/measure"}},
        {"game/program", {"game/saves", "game/sound", "game/menu", "game/lab", "engine/platform/sdl", "tools/gallery"}},
        {"game/dos", {"game/program"}},
        {"game/web", {"game/program"}},
        {"tools/reference", {}},
        {"tools/measure", {"engine/frame", "engine/methods", "engine/platform", "engine/files", "tools/reference"}},
        {"tools/gallery", {"tools/measure"}},
        {"tools", {"tools/measure", "tools/gallery"}},
    };
    return rooms;
}

const Room* find_room(const std::vector<Room>& rooms, std::string_view path) {
    const Room* best = nullptr;
    for (const Room& room : rooms) {
        if (!path.starts_with(room.folder + "/")) continue;
        if (!best || room.folder.size() > best->folder.size()) best = &room;
    }
    return best;
}

bool may_include(const std::vector<Room>& rooms, const Room& from, const Room& to) {
    if (from.folder == to.folder) return true;
    return std::any_of(from.depends.begin(), from.depends.end(), [&](const std::string& folder) {
        const Room* below = find_room(rooms, folder + "/");
        return below && may_include(rooms, *below, to);
    });
}

std::vector<Room> parse_cmake_rooms(const std::string& cmake, const std::string& prefix) {
    std::vector<Room> rooms;
    std::map<std::string, std::string> folders;
    const std::string opening = "oblong_room(";
    for (std::size_t at = cmake.find(opening); at != std::string::npos; at = cmake.find(opening, at + 1)) {
        const std::size_t start = at + opening.size();
        std::istringstream words(cmake.substr(start, cmake.find(')', start) - start));
        std::string name, word, list;
        Room room;
        words >> name >> room.folder;
        room.folder.insert(0, prefix);
        folders[name] = room.folder;
        while (words >> word) {
            if (word == "DEPENDS" || word == "EXTRA_FOLDERS" || word == "EXCEPT")
                list = word;
            else if (list == "DEPENDS")
                room.depends.push_back(folders[word]);
        }
        rooms.push_back(room);
    }
    return rooms;
}

}  // namespace oblong::test
