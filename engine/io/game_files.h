#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/io/files.h"
#include "engine/level/level.h"

namespace oblong {

// Quake's pak files: "PACK", offset and length of the directory (u32 each, little-endian); a directory of entries of 64
// bytes: a zero-terminated name, as "maps/e1m1.bsp" (56 bytes), offset and length of the file (u32 each).

inline constexpr std::size_t kPakHeader_bytes = 12, kPakEntry_bytes = 64, kMostPakEntries = 65'536;

struct PakHeader {
    std::uint32_t directory_offset = 0, directory_length = 0;
};

struct PakEntry {
    std::string name;
    std::uint32_t offset = 0, length = 0;
};

/// Reads the first bytes of a file of `file_bytes`. Throws InputError unless its directory is inside it.
PakHeader read_pak_header(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes);

/// Reads the bytes of the directory. Throws InputError, with the offset in the file, for an entry without a name, a
/// name without an end, and data that is not all in the file or overlaps other data. Two entries may share all of their
/// data.
std::vector<PakEntry> read_pak_directory(std::span<const std::uint8_t> bytes, const PakHeader& header,
                                         std::uint64_t file_bytes);

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

/// Reads the colours of a level's light from a .lit file beside the level's (read_lit_file()), if there is one and the
/// level has none of its own. A warning if the file is of another level: its light stays white.
std::vector<std::string> read_lit_file_beside(const std::string& level_file, Level& level);

/// The folders of a game such as Quake's, with the files in them and in their pak files (pak0.pak, pak1.pak and so on,
/// up to the first missing number; capitals count as small letters).
class GameFiles {
  public:
    GameFiles() = default;
    /// Reads nothing yet: pak files are read when a file is not found beside them.
    explicit GameFiles(std::vector<std::string> folders) : folders_(std::move(folders)) {}

    /// True if one of the folders has a pak file.
    bool has_paks() const { return !paks().empty(); }

    /// The path of a file of that name, as "gfx/palette.lmp": in the first folder that has it; else in a pak file,
    /// folders in order, the highest number first. Throws FileError for a broken pak file.
    std::optional<std::string> find(const std::string& name) const;

    /// The paths of all files in pak files whose names are `prefix`...`suffix`, in the order of find(). The error of a
    /// broken pak file is added to `problems`, and its files are not listed.
    std::vector<std::string> list_in_paks(const std::string& prefix, const std::string& suffix,
                                          std::vector<std::string>& problems) const;

  private:
    const std::vector<std::string>& paks() const;
    const std::vector<PakEntry>& directory_of(const std::string& pak) const;

    std::vector<std::string> folders_;
    mutable std::optional<std::vector<std::string>> paks_;              // once they were looked for
    mutable std::map<std::string, std::vector<PakEntry>> directories_;  // of the pak files that were read
};

}  // namespace oblong
