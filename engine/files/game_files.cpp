#include "engine/files/game_files.h"

#include <algorithm>
#include <filesystem>

namespace oblong {
namespace {

namespace fs = std::filesystem;

std::vector<PakEntry> read_directory(const std::string& pak) {
    std::error_code error;
    const std::uint64_t size = fs::file_size(pak, error);
    if (error) throw FileError(pak, "size", error.message() + ", expected a readable file");
    return naming_file(pak, [&] {
        const PakHeader header = read_pak_header(read_file_part(pak, 0, kPakHeader_bytes), size);
        return read_pak_directory(read_file_part(pak, header.directory_offset, header.directory_length), header, size);
    });
}

// The first entry of that name, as in Quake; null if there is none.
const PakEntry* find_entry(const std::vector<PakEntry>& entries, const std::string& name) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const PakEntry& entry) { return entry.name == name; });
    return found == entries.end() ? nullptr : &*found;
}

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

}  // namespace

std::optional<PathInPak> path_in_pak(const std::string& path) {
    const fs::path whole(path);
    fs::path pak;
    for (auto part = whole.begin(); part != whole.end(); ++part) {
        pak /= *part;
        if (part->extension() != ".pak" || std::next(part) == whole.end() || !is_file(pak)) continue;
        return PathInPak{pak.string(), whole.lexically_relative(pak).generic_string()};
    }
    return {};
}

std::vector<std::uint8_t> read_game_file(const std::string& path) {
    const auto inside = path_in_pak(path);
    if (!inside) return read_file(path);
    const std::vector<PakEntry> entries = read_directory(inside->pak);
    const PakEntry* entry = find_entry(entries, inside->name);
    if (entry == nullptr) throw FileError(inside->pak, "directory", "no " + inside->name + ", expected it there");
    return read_file_part(inside->pak, entry->offset, entry->length);
}

bool GameFiles::has_paks() const {
    return !paks().empty();
}

std::vector<std::string> GameFiles::paks() const {
    std::vector<std::string> found;
    for (const std::string& folder : folders_) {
        const std::size_t first = found.size();
        for (int number = 0;; ++number) {
            const fs::path pak = fs::path(folder) / ("pak" + std::to_string(number) + ".pak");
            if (!is_file(pak)) break;
            found.push_back(pak.lexically_normal().string());
        }
        std::reverse(found.begin() + static_cast<std::ptrdiff_t>(first), found.end());
    }
    return found;
}

const std::vector<PakEntry>& GameFiles::directory_of(const std::string& pak) const {
    const auto known = directories_.find(pak);
    return known != directories_.end() ? known->second : directories_.emplace(pak, read_directory(pak)).first->second;
}

std::optional<std::string> GameFiles::find(const std::string& name) const {
    for (const std::string& folder : folders_)
        if (const fs::path file = fs::path(folder) / name; is_file(file)) return file.lexically_normal().string();
    for (const std::string& pak : paks())
        if (find_entry(directory_of(pak), name) != nullptr) return (fs::path(pak) / name).string();
    return {};
}

std::vector<std::string> GameFiles::list_in_paks(const std::string& prefix, const std::string& suffix,
                                                 std::vector<std::string>& problems) const {
    std::vector<std::string> found;
    for (const std::string& pak : paks()) {
        try {
            for (const PakEntry& entry : directory_of(pak))
                if (entry.name.starts_with(prefix) && entry.name.ends_with(suffix))
                    found.push_back((fs::path(pak) / entry.name).string());
        } catch (const FileError& error) {
            problems.emplace_back(error.what());
        }
    }
    return found;
}

}  // namespace oblong
