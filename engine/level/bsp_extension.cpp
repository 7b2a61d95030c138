#include <algorithm>
#include <string>
#include <string_view>

#include "engine/base/little_endian.h"
#include "engine/level/bsp_file.h"
#include "engine/level/bsp_read.h"

namespace oblong {
namespace {

constexpr std::int64_t kHeadSize = 8, kEntrySize = 32, kEntryName = 24;
constexpr std::string_view kColouredLighting = "RGBLIGHTING";

/// A part of the file; throws, naming `what`, if it is not all within.
std::span<const std::uint8_t> part_of(const BspFile& file, std::int64_t offset, std::int64_t size,
                                      const std::string& what) {
    const auto all = static_cast<std::int64_t>(file.bytes.size());
    if (offset < 0 || size < 0 || offset + size > all)
        throw InputError("BSPX " + what, "offset " + std::to_string(offset) + ", size " + std::to_string(size) +
                                             ", expected an end within the " + std::to_string(all) + " bytes");
    return file.bytes.subspan(as_size(offset), as_size(size));
}

/// Where the list of lumps begins: behind the last ordinary lump, at a multiple of four.
std::int64_t end_of_lumps(const BspFile& file) {
    std::int64_t end = kBspHeaderSize;
    for (const LumpRange& lump : file.lumps) end = std::max(end, std::int64_t{lump.offset} + lump.size);
    return (end + 3) / 4 * 4;
}

bool begins_with(std::span<const std::uint8_t> bytes, std::string_view text) {
    return bytes.size() >= text.size() && std::equal(text.begin(), text.end(), bytes.begin());
}

}  // namespace

std::vector<std::uint8_t> read_coloured_lighting(const BspFile& file) {
    const std::int64_t head = end_of_lumps(file);
    if (head + kHeadSize > static_cast<std::int64_t>(file.bytes.size())) return {};
    const std::span<const std::uint8_t> rest = file.bytes.subspan(as_size(head));
    if (!begins_with(rest, "BSPX")) return {};
    const std::int64_t count = little_endian_u32(rest.data() + 4);
    const auto entries =
        part_of(file, head + kHeadSize, count * kEntrySize, "list of " + std::to_string(count) + " lumps");
    for (std::int64_t i = 0; i < count; ++i) {
        const auto entry = entries.subspan(as_size(i * kEntrySize), kEntrySize);
        if (!begins_with(entry, kColouredLighting) || entry[kColouredLighting.size()] != 0) continue;
        const auto bytes = part_of(file, little_endian_u32(&entry[kEntryName]),
                                   little_endian_u32(&entry[kEntryName + 4]), "lump 'RGBLIGHTING'");
        if (bytes.size() != 3 * as_size(file.count(Lump::Lighting))) return {};
        return {bytes.begin(), bytes.end()};
    }
    return {};
}

void read_lit_file(std::span<const std::uint8_t> bytes, Level& level) {
    constexpr std::size_t kHead = 8;
    const bool has_head = begins_with(bytes, "QLIT") && bytes.size() >= kHead;
    expect_at(0, has_head && little_endian_u32(&bytes[4]) == 1, "no such head, expected \"QLIT\" and version 1");
    const std::size_t wanted = 3 * level.lighting.size();
    expect_at(kHead, bytes.size() - kHead == wanted,
              std::to_string(bytes.size() - kHead) + " bytes of colours, expected " + std::to_string(wanted) +
                  ", three for each light sample of the level");
    level.coloured_lighting.assign(bytes.begin() + kHead, bytes.end());
}

}  // namespace oblong
