#include "tools/map/trenchbroom.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "engine/files/files.h"
#include "tools/map/source/fgd.h"

namespace oblong::map {
namespace {

namespace fs = std::filesystem;

fs::path without_tilde(const std::string& folder) {
    const char* const home = std::getenv("HOME");
    if (!folder.starts_with("~/")) return folder;
    if (home == nullptr) throw FileError(folder, "HOME", "is not set, expected the user's folder, or a folder by name");
    return fs::path(home) / folder.substr(2);
}

// For a quoted string in one of the editor's files.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') out += '\\';
        out += letter;
    }
    return out;
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + by.size()))
        text.replace(at, part.size(), by);
    return text;
}

void copy_folder(const fs::path& from, const fs::path& to) {
    make_folder(to.string());
    for (const fs::directory_entry& file : fs::directory_iterator(from))
        if (file.is_regular_file()) write_file((to / file.path().filename()).string(), read_file(file.path().string()));
}

// Numbered, so that files that were kept earlier stay.
std::string free_name_beside(const fs::path& path) {
    std::string name = path.string() + ".old";
    for (int number = 2; fs::exists(fs::symlink_status(name)); ++number)
        name = path.string() + ".old" + std::to_string(number);
    return name;
}

void write_kept(const fs::path& path, const std::string& text) {
    if (!fs::exists(path) || read_text(path.string()) == text) return write_file(path.string(), text);
    const std::string old = free_name_beside(path);
    replace_file(path.string(), old, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
    std::cout << path.string() << " was changed: kept as " << old << '\n';
}

}  // namespace

void install_trenchbroom(const std::string& folder, const char* called_as) {
    const fs::path to = fs::absolute(without_tilde(folder)), assets = fs::absolute(assets_folder(called_as)),
                   programs = fs::absolute(program_folder(called_as));
    make_folder((to / "assets" / "gfx").string());
    for (const char* const name :
         {"GameConfig.cfg", "CompilationProfiles.cfg", "GameEngineProfiles.cfg", "initial_valve.map"}) {
        std::string text = read_text((assets / "trenchbroom" / name).string());
        text = replaced(text, "@oblong-map@", escaped((programs / "oblong-map").string()));
        text = replaced(text, "@oblong@", escaped((programs / "oblong").string()));
        text = replaced(text, "@assets@", escaped(assets.string()));
        write_kept(to / name, text);
    }
    write_file((to / "Icon.png").string(), read_file((assets / "trenchbroom" / "Icon.png").string()));
    write_file((to / "Oblong.fgd").string(), fgd_text());
    write_file((to / "assets" / "gfx" / "palette.lmp").string(), read_file((assets / "palette.lmp").string()));
    copy_folder(assets / "models", to / "assets" / "models");
    std::cout << "TrenchBroom's configuration for Oblong is in " << to.string()
              << ". Start the editor again, and choose Oblong for a new map.\n";
}

}  // namespace oblong::map
