#include "engine/io/game_files.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "engine/base/little_endian.h"
#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/level/bsp_read.h"

namespace oblong {
namespace {

constexpr std::string_view kMagic = "PACK";
constexpr std::size_t kName_bytes = 56;

// A range of the file: of the entry at `entry_offset`, or of header or directory (0).
struct Range {
    std::uint64_t begin = 0, end = 0;
    std::uint64_t entry_offset = 0;

    bool is_same(const Range& other) const { return begin == other.begin && end == other.end; }
};

std::string read_name(std::span<const std::uint8_t> field, std::size_t offset) {
    const auto end = std::find(field.begin(), field.end(), std::uint8_t{0});
    expect_at(offset, end != field.end(), "a name without an end, expected a zero byte among its 56");
    expect_at(offset, end != field.begin(), "an entry without a name, expected one");
    return {field.begin(), end};
}

PakEntry read_entry(LittleEndianReader& in, std::size_t offset, std::uint64_t file_bytes) {
    PakEntry entry;
    entry.name = read_name(in.take(kName_bytes), offset);
    entry.offset = in.next<std::uint32_t>();
    entry.length = in.next<std::uint32_t>();
    expect_at(offset + kName_bytes, std::uint64_t{entry.offset} + entry.length <= file_bytes,
              entry.name + " has " + std::to_string(entry.length) + " bytes from " + std::to_string(entry.offset) +
                  " on, expected them in the file's " + std::to_string(file_bytes));
    return entry;
}

// Each range begins after the previous one, or is the same.
void check_overlaps(std::vector<Range> ranges) {
    std::sort(ranges.begin(), ranges.end(),
              [](const Range& a, const Range& b) { return a.begin != b.begin ? a.begin < b.begin : a.end < b.end; });
    for (std::size_t i = 1; i < ranges.size(); ++i) {
        const Range &before = ranges[i - 1], &range = ranges[i];
        const bool are_entries = before.entry_offset != 0 && range.entry_offset != 0;
        if (before.end <= range.begin || (are_entries && before.is_same(range))) continue;
        const std::uint64_t offset = std::max(before.entry_offset, range.entry_offset);
        expect_at(as_size(offset), false,
                  "data from " + std::to_string(range.begin) + " on, where other data is, expected it apart");
    }
}

}  // namespace

PakHeader read_pak_header(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes) {
    expect_at(0, bytes.size() >= kPakHeader_bytes && std::equal(kMagic.begin(), kMagic.end(), bytes.begin()),
              "no pak file: expected 'PACK' and 8 more bytes");
    LittleEndianReader in(bytes, kMagic.size());
    PakHeader header;
    header.directory_offset = in.next<std::uint32_t>();
    header.directory_length = in.next<std::uint32_t>();
    const std::uint64_t end = std::uint64_t{header.directory_offset} + header.directory_length;
    expect_at(4, header.directory_offset >= kPakHeader_bytes && end <= file_bytes,
              "a directory of " + std::to_string(header.directory_length) + " bytes at " +
                  std::to_string(header.directory_offset) + ", expected it behind the header in a file of " +
                  std::to_string(file_bytes));
    expect_at(8, header.directory_length % kPakEntry_bytes == 0,
              "a directory of " + std::to_string(header.directory_length) + " bytes, expected a multiple of 64");
    expect_at(8, header.directory_length / kPakEntry_bytes <= kMostPakEntries,
              std::to_string(header.directory_length / kPakEntry_bytes) + " entries, expected at most 65,536");
    return header;
}

std::vector<PakEntry> read_pak_directory(std::span<const std::uint8_t> bytes, const PakHeader& header,
                                         std::uint64_t file_bytes) {
    std::vector<PakEntry> entries;
    std::vector<Range> ranges{{0, kPakHeader_bytes},
                              {header.directory_offset, header.directory_offset + std::uint64_t{bytes.size()}}};
    LittleEndianReader in(bytes);
    while (in.rest() > 0) {
        const std::size_t offset = header.directory_offset + in.offset();
        const PakEntry& entry = entries.emplace_back(read_entry(in, offset, file_bytes));
        if (entry.length > 0)
            ranges.push_back({entry.offset, std::uint64_t{entry.offset} + entry.length, std::uint64_t{offset}});
    }
    check_overlaps(std::move(ranges));
    return entries;
}

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

// The files of a folder whose names end in .pak, by these names in small letters: on DOS's disks they have capitals. Of
// two names that differ in nothing else, the one in small letters counts.
std::map<std::string, fs::path> paks_in(const std::string& folder) {
    std::map<std::string, fs::path> paks;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string(), lower = lower_case(name);
        if (!lower.ends_with(".pak") || !is_file(entry->path())) continue;
        fs::path& file = paks[lower];
        if (file.empty() || name == lower) file = entry->path();
    }
    return paks;
}

}  // namespace

std::optional<PathInPak> path_in_pak(const std::string& path) {
    const fs::path whole(path);
    fs::path pak;
    for (auto part = whole.begin(); part != whole.end(); ++part) {
        pak /= *part;
        if (lower_case(part->extension().string()) != ".pak" || std::next(part) == whole.end() || !is_file(pak))
            continue;
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

std::vector<std::string> read_lit_file_beside(const std::string& level_file, Level& level) {
    const fs::path file = fs::path(level_file).replace_extension(".lit");
    const auto inside = path_in_pak(file.string());
    const bool is_there = inside ? find_entry(read_directory(inside->pak), inside->name) != nullptr : is_file(file);
    if (!is_there || !level.coloured_lighting.empty()) return {};
    try {
        read_lit_file(read_game_file(file.string()), level);
    } catch (const InputError& error) {
        return {file.filename().string() + ": " + error.where + ": " + error.what() + ": all light is white"};
    }
    return {};
}

const std::vector<std::string>& GameFiles::paks() const {
    if (paks_) return *paks_;
    paks_.emplace();
    for (const std::string& folder : folders_) {
        const std::map<std::string, fs::path> there = paks_in(folder);
        std::vector<std::string> found;
        for (auto pak = there.find("pak0.pak"); pak != there.end();
             pak = there.find("pak" + std::to_string(found.size()) + ".pak"))
            found.push_back(pak->second.lexically_normal().string());
        paks_->insert(paks_->end(), found.rbegin(), found.rend());
    }
    return *paks_;
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
