#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/files/files.h"
#include "engine/files/pak.h"

namespace oblong {

// A file in a pak file has a path as if the pak file were a folder: "id1/pak0.pak/maps/e1m1.bsp".

/// The pak file of such a path, and the name in it; nothing for the path of a plain file.
struct PathInPak {
    std::string pak, name;
};
std::optional<PathInPak> path_in_pak(const std::string& path);

/// All bytes of a plain file or of a file in a pak. Throws FileError.
std::vector<std::uint8_t> read_game_file(const std::string& path);

/// Returns parse(all bytes of such a file); an InputError becomes a FileError with the file's path. Throws FileError.
template <class Parse>
auto read_parsed_game_file(const std::string& path, Parse parse) {
    const std::vector<std::uint8_t> bytes = read_game_file(path);
    return naming_file(path, [&] { return parse(std::span<const std::uint8_t>(bytes)); });
}

/// The folders of a game such as Quake's, with the files in them and in their pak files (pak0.pak, pak1.pak and so on,
/// up to the first missing number).
class GameFiles {
  public:
    GameFiles() = default;
    /// Reads nothing yet: pak files are read when a file is not found beside them.
    explicit GameFiles(std::vector<std::string> folders) : folders_(std::move(folders)) {}

    const std::vector<std::string>& folders() const { return folders_; }
    /// True if one of the folders has a pak file.
    bool has_paks() const;

    /// The path of a file of that name, as "gfx/palette.lmp": in the first folder that has it; else in a pak file,
    /// folders in order, the highest number first. Throws FileError for a broken pak file.
    std::optional<std::string> find(const std::string& name) const;

    /// The paths of all files in pak files whose names are `prefix`...`suffix`, in the order of find(). The error of a
    /// broken pak file is added to `problems`, and its files are not listed.
    std::vector<std::string> list_in_paks(const std::string& prefix, const std::string& suffix,
                                          std::vector<std::string>& problems) const;

  private:
    std::vector<std::string> paks() const;
    const std::vector<PakEntry>& directory_of(const std::string& pak) const;

    std::vector<std::string> folders_;
    mutable std::map<std::string, std::vector<PakEntry>> directories_;  // of the pak files that were read
};

}  // namespace oblong
