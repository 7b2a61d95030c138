#include "engine/files/pak.h"

#include <algorithm>
#include <string_view>

#include "engine/base/little_endian.h"
#include "engine/base/table.h"

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

std::string to_text(std::uint64_t number) {
    return std::to_string(number);
}

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
              entry.name + " has " + to_text(entry.length) + " bytes from " + to_text(entry.offset) +
                  " on, expected them in the file's " + to_text(file_bytes));
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
                  "data from " + to_text(range.begin) + " on, where other data is, expected it apart");
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
              "a directory of " + to_text(header.directory_length) + " bytes at " + to_text(header.directory_offset) +
                  ", expected it behind the header in a file of " + to_text(file_bytes));
    expect_at(8, header.directory_length % kPakEntry_bytes == 0,
              "a directory of " + to_text(header.directory_length) + " bytes, expected a multiple of 64");
    expect_at(8, header.directory_length / kPakEntry_bytes <= kMostPakEntries,
              to_text(header.directory_length / kPakEntry_bytes) + " entries, expected at most 65,536");
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

}  // namespace oblong
